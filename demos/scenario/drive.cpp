#include "scenario/drive.h"

#include "polhode/rotation_math.h"
#include "polhode/torque_laws.h"

namespace polhode::demos {

namespace {

TorqueLaw law_of(const GravityGradient& planet) {
  return gravity_gradient(planet.mu, planet.centre_W);
}

TorqueLaw law_of(const MagneticDipole& magnet) {
  return magnetic_dipole(magnet.dipole_B, magnet.field_W);
}

TorqueLaw law_of(const OrientationSpring& spring) {
  return orientation_spring(spring.target_WB, spring.stiffness);
}

TorqueLaw law_of(const RateDamping& damping) {
  return rate_damping(damping.coefficients_B);
}

TorqueLaw law_of(const InternalDamping& damping) {
  return internal_damping(damping.moment, damping.coefficient);
}

// -mu m / r + 3 mu / (2 r^3) u . I u, u the direction from the planet's centre to the body
double potential_of(const GravityGradient& planet, const Placement& body) {
  const Vector3 r_W = body.position_W - planet.centre_W;
  const double distance = r_W.norm();
  const Vector3 u_B = body.q_WB.conjugate() * (r_W / distance);
  return planet.mu / distance *
         (1.5 / (distance * distance) * u_B.dot(body.inertia_B.cwiseProduct(u_B)) - body.mass);
}

double potential_of(const MagneticDipole& magnet, const Placement& body) {
  return -magnet.field_W.dot(body.q_WB * magnet.dipole_B);
}

double potential_of(const OrientationSpring& spring, const Placement& body) {
  return 0.5 * spring.stiffness * logarithm(body.q_WB * spring.target_WB.conjugate()).squaredNorm();
}

double potential_of(const RateDamping& /*damping*/, const Placement& /*body*/) {
  return 0.0;
}

double potential_of(const InternalDamping& /*damping*/, const Placement& /*body*/) {
  return 0.0;
}

}  // namespace

Vector3 GravityGradient::acceleration_W(const Vector3& position_W) const {
  const Vector3 r_W = position_W - centre_W;
  const double distance = r_W.norm();
  return -mu / (distance * distance * distance) * r_W;
}

bool Drive::has_rotors() const {
  return !rotor_momentum_B.isZero(0.0) || !motor_torques.empty() ||
         (law && std::holds_alternative<InternalDamping>(*law));
}

Vector3 Drive::motor_torque_B(double t_s) const {
  Vector3 sum_B = Vector3::Zero();
  for (const MotorTorque& torque : motor_torques) {
    if (torque.from_s <= t_s && t_s < torque.until_s) sum_B += torque.torque_B;
  }
  return sum_B;
}

TorqueLaw torque_law(const ChosenLaw& law) {
  return std::visit([](const auto& chosen) { return law_of(chosen); }, law);
}

double potential_J(const ChosenLaw& law, const Placement& body) {
  return std::visit([&](const auto& chosen) { return potential_of(chosen, body); }, law);
}

}  // namespace polhode::demos
