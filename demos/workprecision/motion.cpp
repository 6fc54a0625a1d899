#include "workprecision/motion.h"

#include <algorithm>
#include <cmath>

#include "command_line/interruption.h"
#include "polhode/rotation_limits.h"

namespace polhode::demos {

namespace {

// Judges a body as the library does; a figure of the motion needs its energy too.
bool is_sound(const RotationState& state) {
  return within_limits(state) && std::isfinite(state.energy());
}

}  // namespace

Motion follow(Kernel& kernel, std::int64_t steps) {
  Motion motion;
  kernel.restart();
  const double start_energy_J = kernel.state().energy();
  while (motion.steps < steps) {
    throw_if_interrupted();
    kernel.run(1);
    const RotationState state = kernel.state();
    if (!is_sound(state)) {
      motion.diverged = true;
      return motion;
    }
    ++motion.steps;
    motion.worst_energy_error =
        std::max(motion.worst_energy_error, std::abs(state.energy() / start_energy_J - 1.0));
  }
  return motion;
}

}  // namespace polhode::demos
