#include "world/driver.h"

#include "world/conversions.h"

namespace polhode::demos {

Driver::Driver(ScenarioBody& body, const Drive& drive, RotationControl* rotation)
    : body_(body), drive_(drive), rotation_(rotation) {
  if (drive_.law) law_ = torque_law(*drive_.law);
  if (rotation_ == nullptr) return;
  if (law_ != nullptr) rotation_->set_torque_law(body_.object(), law_);
  if (!drive_.rotor_momentum_B.isZero(0.0)) {
    rotation_->set_rotor_momentum(body_.object(), drive_.rotor_momentum_B, RotorChange::from_outside);
  }
}

void Driver::before_step(double t_s, double dt_s) {
  if (const auto* planet = drive_.law ? std::get_if<GravityGradient>(&*drive_.law) : nullptr) {
    pull_to_planet(*planet);
  }
  // Middle of the step, so that a time slightly off a whole step counts as that step.
  const Vector3 motor_torque_B = drive_.motor_torque_B(t_s + 0.5 * dt_s);
  if (rotation_ == nullptr) {
    apply_torques(t_s, motor_torque_B);
  } else if (motor_torque_B != motor_torque_B_) {
    rotation_->set_rotor_torque(body_.object(), motor_torque_B);
    motor_torque_B_ = motor_torque_B;
  }
}

void Driver::pull_to_planet(const GravityGradient& planet) {
  const Vector3 acceleration_W =
      planet.acceleration_W(from_bullet(body_.object().getWorldTransform().getOrigin()));
  if (acceleration_W.allFinite()) body_.apply_acceleration(acceleration_W);
}

void Driver::apply_torques(double t_s, const Vector3& motor_torque_B) {
  Torque torque = RotorTorque{motor_torque_B};
  if (law_ != nullptr) torque = torque + law_(motion(t_s));
  // Skips a law's torque that is not finite, as the library does.
  if (!torque.all_finite()) return;
  if (law_ != nullptr) body_.apply_torque(torque.world_W + body_.rotation().q_WB * torque.body_B);
  if (!torque.rotor_B.isZero(0.0)) body_.apply_rotor_torque(torque.rotor_B);
}

TorqueLawInput Driver::motion(double t_s) const {
  const RotationState state = body_.rotation();
  return {t_s,
          state.q_WB,
          state.omega_W,
          from_bullet(body_.object().getWorldTransform().getOrigin()),
          body_.velocity_W(),
          body_.inertia_B(),
          state.rotor_momentum_B};
}

}  // namespace polhode::demos
