#include "free_motion.h"

#include <stdexcept>
#include <string>

#include "polhode/rotation_limits.h"

namespace polhode::python {

namespace {

void take_step(FreeMotion& motion, double time_s, RotationState& state) {
  const StepInput input{motion.inertia_B, Vector3::Zero(), motion.dt};
  if (!motion.drive.acts()) return motion.scheme.step(input, state);
  const DrivenStep step = take_driven_step(motion.scheme, input, {time_s, motion.position_W, Vector3::Zero()},
                                           motion.drive, state);
  if (step.law_failed) {
    throw std::runtime_error(
        "the torque law failed in the step from t = " + std::to_string(time_s) +
        " s: it must return a finite torque, and none on rotors for a scheme that takes none");
  }
  state = step.end;
  motion.drive.last_torque = step.last_torque;
}

}  // namespace

Divergence run_free_motion(FreeMotion motion, const std::function<void(const demos::Sample&)>& observe) {
  RotationState state = motion.start;
  const auto sample = [&](std::int64_t step) {
    return demos::Sample{step, static_cast<double>(step) * motion.dt, state, motion.position_W,
                         state.energy()};
  };
  observe(sample(0));
  for (std::int64_t step = 1; step <= motion.steps; ++step) {
    take_step(motion, static_cast<double>(step - 1) * motion.dt, state);
    if (!within_limits(state)) return step;
    observe(sample(step));
  }
  return std::nullopt;
}

}  // namespace polhode::python
