#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "polhode/torque_law.h"

/// The content of the keys "torque_law", "rotor_momentum" and "rotor_torque", in SI units.
namespace polhode::demos {

/// A planet whose gravity pulls and turns the body.
struct GravityGradient {
  static constexpr char kKind[] = "gravity_gradient";
  double mu = 0.0;  ///< gravitational parameter, m^3/s^2
  Vector3 centre_W = Vector3::Zero();

  Vector3 acceleration_W(const Vector3& position_W) const;
};

struct MagneticDipole {
  static constexpr char kKind[] = "magnetic_dipole";
  Vector3 dipole_B = Vector3::Zero();
  Vector3 field_W = Vector3::Zero();
};

struct OrientationSpring {
  static constexpr char kKind[] = "spring";
  Quaternion target_WB = Quaternion::Identity();
  double stiffness = 0.0;
};

struct RateDamping {
  static constexpr char kKind[] = "rate_damping";
  Vector3 coefficients_B = Vector3::Zero();
};

/// A damper about each axis of the body: a rotor that the body drags along.
struct InternalDamping {
  static constexpr char kKind[] = "internal_damping";
  double moment = 0.0;
  double coefficient = 0.0;
};

using ChosenLaw =
    std::variant<GravityGradient, MagneticDipole, OrientationSpring, RateDamping, InternalDamping>;

/// A torque of motors inside the body on its rotors, for a limited time.
struct MotorTorque {
  Vector3 torque_B = Vector3::Zero();
  double from_s = 0.0;
  double until_s = 1e11;
};

struct Drive {
  Vector3 rotor_momentum_B = Vector3::Zero();  ///< at the start
  std::vector<MotorTorque> motor_torques;
  std::optional<ChosenLaw> law;

  bool has_rotors() const;
  /// Returns true if nothing but rotors with constant momentum drives the body, or nothing at all.
  bool is_torque_free() const { return motor_torques.empty() && !law; }
  /// Returns the sum of the rotor torques that act at this time.
  Vector3 motor_torque_B(double t_s) const;
};

/// Returns the library's law.
TorqueLaw torque_law(const ChosenLaw& law);

/// The part of a body's motion that the potential energy of a law depends on.
struct Placement {
  Quaternion q_WB;
  Vector3 position_W;
  Vector3 inertia_B;
  double mass;
};

/// Returns the potential energy of the law, including that of a planet's pull; 0 for a law that damps.
double potential_J(const ChosenLaw& law, const Placement& body);

}  // namespace polhode::demos
