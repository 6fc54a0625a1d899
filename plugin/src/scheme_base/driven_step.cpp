#include "scheme_base/driven_step.h"

#include <array>
#include <cstddef>

#include "polhode/rotation_math.h"

namespace polhode {

namespace {

// Thrown if the law throws or its torque cannot be used.
struct LawFailure {};

class Stepper {
 public:
  Stepper(const RotationScheme& scheme, const StepInput& input, const StepStart& start, const Drive& drive,
          const RotationState& state)
      : scheme_(scheme),
        takes_rotors_(scheme.description().takes_rotors),
        input_(input),
        start_(start),
        drive_(drive),
        state_(state) {}

  const RotationState& state() const { return state_; }

  // The first drift also applies the kick of the step's input.
  void drift(double part) {
    scheme_.step({input_.inertia_B, input_.delta_omega_W, part * input_.dt}, state_);
    input_.delta_omega_W.setZero();
    time_ += part;
  }

  void ramp_rotor(double part) {
    if (drive_.rotor_torque_B.isZero(0.0)) return;
    const Vector3 change_B = part * input_.dt * drive_.rotor_torque_B;
    change_rotor_by_motor(input_.inertia_B, state_.rotor_momentum_B + change_B, state_);
  }

  // Returns the torque of the law for this motion, at the present time.
  Torque evaluate_law(const RotationState& motion) const {
    const double seconds = time_ * input_.dt;
    const Torque torque = drive_.law({start_.time_s + seconds, motion.q_WB, motion.omega_W,
                                      start_.position_W + seconds * start_.velocity_W, start_.velocity_W,
                                      input_.inertia_B, motion.rotor_momentum_B});
    if (!torque.all_finite() || (!takes_rotors_ && !torque.rotor_B.isZero(0.0))) throw LawFailure();
    return torque;
  }

  // Returns state_ after the torque has acted for a part of dt.
  RotationState kicked(const Torque& torque, double part) const {
    RotationState result = state_;
    const double seconds = part * input_.dt;
    result.rotor_momentum_B += seconds * torque.rotor_B;
    const Vector3 change_W = seconds * (torque.world_W + state_.R_WB * torque.body_B);
    set_angular_momentum(result, input_.inertia_B, state_.L_W + change_W);
    return result;
  }

  void kick(const Torque& torque, double part) { state_ = kicked(torque, part); }

  // Adds the law's torque to the kick with which the scheme's step begins.
  Torque kick_at_start() {
    const Torque torque = evaluate_law(state_);
    const RotationState after = kicked(torque, 1.0);
    input_.delta_omega_W += after.omega_W - state_.omega_W;
    if (after.rotor_momentum_B != state_.rotor_momentum_B) {
      state_.L_W += state_.R_WB * (after.rotor_momentum_B - state_.rotor_momentum_B);  // for the same omega
      state_.rotor_momentum_B = after.rotor_momentum_B;
    }
    return torque;
  }

  Torque kick_in_middle() {
    const Torque before = drive_.last_torque ? *drive_.last_torque : evaluate_law(state_);
    const Torque torque = evaluate_law(kicked(before, 0.5));
    kick(torque, 1.0);
    return torque;
  }

  // The flow of the torque at a fixed orientation. Evaluates a torque that does not depend on the velocity
  // only twice.
  void kick_by_runge_kutta(double part) {
    const Torque k1 = evaluate_law(state_);
    const Torque k2 = evaluate_law(kicked(k1, 0.5 * part));
    if (k2 == k1) {
      kick(k1, part);
      return;
    }
    const Torque k3 = evaluate_law(kicked(k2, 0.5 * part));
    const Torque k4 = evaluate_law(kicked(k3, part));
    Torque mean;
    mean.world_W = (k1.world_W + 2.0 * (k2.world_W + k3.world_W) + k4.world_W) / 6.0;
    mean.body_B = (k1.body_B + 2.0 * (k2.body_B + k3.body_B) + k4.body_B) / 6.0;
    mean.rotor_B = (k1.rotor_B + 2.0 * (k2.rotor_B + k3.rotor_B) + k4.rotor_B) / 6.0;
    kick(mean, part);
  }

 private:
  const RotationScheme& scheme_;
  bool takes_rotors_;
  StepInput input_;
  const StepStart& start_;
  const Drive& drive_;
  RotationState state_;
  double time_ = 0.0;  // since the start of the step, in units of dt
};

// The coefficients a_1 ... a_7 and b_1 ... b_6.
struct BlanesMoan {
  static constexpr double kA1 = 0.0792036964311957;
  static constexpr double kA2 = 0.353172906049774;
  static constexpr double kA3 = -0.0420650803577195;
  static constexpr double kB1 = 0.209515106613362;
  static constexpr double kB2 = -0.143851773179818;
  static constexpr double kA4 = 1.0 - 2.0 * (kA1 + kA2 + kA3);
  static constexpr double kB3 = 0.5 - (kB1 + kB2);
  static constexpr std::array<double, 7> kDrifts = {kA1, kA2, kA3, kA4, kA3, kA2, kA1};
  static constexpr std::array<double, 6> kKicks = {kB1, kB2, kB3, kB3, kB2, kB1};
};

void take_step_without_law(Stepper& stepper) {
  stepper.ramp_rotor(0.5);
  stepper.drift(1.0);
  stepper.ramp_rotor(0.5);
}

// Returns the torque to predict the velocity in the next step.
std::optional<Torque> take_step_with_law(Stepper& stepper, const RotationScheme& scheme,
                                         TorqueLawOrder order) {
  std::optional<Torque> last_torque;
  stepper.ramp_rotor(0.5);
  if (scheme.description().order == 1) {
    last_torque = stepper.kick_at_start();
    stepper.drift(1.0);
  } else if (order == TorqueLawOrder::two) {
    stepper.drift(0.5);
    last_torque = stepper.kick_in_middle();
    stepper.drift(0.5);
  } else {
    stepper.drift(BlanesMoan::kDrifts[0]);
    for (std::size_t i = 0; i < BlanesMoan::kKicks.size(); ++i) {
      stepper.kick_by_runge_kutta(BlanesMoan::kKicks[i]);
      stepper.drift(BlanesMoan::kDrifts[i + 1]);
    }
  }
  stepper.ramp_rotor(0.5);
  return last_torque;
}

}  // namespace

DrivenStep take_driven_step(const RotationScheme& scheme, const StepInput& input, const StepStart& start,
                            const Drive& drive, const RotationState& state) noexcept {
  bool law_failed = false;
  if (drive.law != nullptr) {
    try {
      Stepper stepper(scheme, input, start, drive, state);
      const std::optional<Torque> last_torque = take_step_with_law(stepper, scheme, drive.order);
      return {stepper.state(), last_torque, false};
    } catch (...) {  // from the law; cannot be handled within a step
      law_failed = true;
    }
  }
  Stepper stepper(scheme, input, start, drive, state);
  take_step_without_law(stepper);
  return {stepper.state(), std::nullopt, law_failed};
}

DriveGain gain_at_start(const RotationScheme& scheme, const StepInput& input, const StepStart& start,
                        const Drive& drive, const RotationState& state) noexcept {
  DriveGain gain{Vector3::Zero(), state.rotor_momentum_B + input.dt * drive.rotor_torque_B, std::nullopt,
                 false};
  if (drive.law == nullptr) return gain;
  try {
    const Torque torque = Stepper(scheme, input, start, drive, state).evaluate_law(state);
    gain.L_W = input.dt * (torque.world_W + state.R_WB * torque.body_B);
    gain.rotor_end_B += input.dt * torque.rotor_B;
    gain.last_torque = torque;
  } catch (...) {
    gain.law_failed = true;
  }
  return gain;
}

void change_rotor_by_motor(const Vector3& inertia_B, const Vector3& rotor_momentum_B, RotationState& state) {
  state.rotor_momentum_B = rotor_momentum_B;
  set_angular_momentum(state, inertia_B, state.L_W);
}

}  // namespace polhode
