#pragma once

#include <functional>
#include <string_view>

#include "polhode/rotation_state.h"

namespace polhode {

/// The motion of a body at the time at which a torque law is evaluated.
struct TorqueLawInput {
  double time_s;
  Quaternion q_WB;           ///< orientation
  Vector3 omega_W;           ///< angular velocity, rad/s
  Vector3 position_W;        ///< of the centre of mass, m
  Vector3 velocity_W;        ///< of the centre of mass, m/s
  Vector3 inertia_B;         ///< principal moments, kg m^2
  Vector3 rotor_momentum_B;  ///< RotationState::rotor_momentum_B, kg m^2/s

  Vector3 omega_B() const { return q_WB.conjugate() * omega_W; }
};

/// @name Torques that a law may return
/// In N m.
/// @{
/// A torque in world axes.
struct WorldTorque {
  Vector3 torque_W;
};
/// A torque in body axes.
struct BodyTorque {
  Vector3 torque_B;
};
/// The torque of motors inside the body on its rotors, in body axes. The body receives the opposite torque:
/// the total angular momentum does not change.
struct RotorTorque {
  Vector3 torque_B;
};
/// @}

/// The sum of all torques on a body. Each of the types above converts to a Torque.
struct Torque {
  Torque() = default;
  Torque(const WorldTorque& torque) : world_W(torque.torque_W) {}  // NOLINT(google-explicit-constructor)
  Torque(const BodyTorque& torque) : body_B(torque.torque_B) {}    // NOLINT(google-explicit-constructor)
  Torque(const RotorTorque& torque) : rotor_B(torque.torque_B) {}  // NOLINT(google-explicit-constructor)

  Vector3 world_W = Vector3::Zero();
  Vector3 body_B = Vector3::Zero();
  Vector3 rotor_B = Vector3::Zero();  ///< on the rotors

  bool all_finite() const { return world_W.allFinite() && body_B.allFinite() && rotor_B.allFinite(); }
};

inline bool operator==(const Torque& a, const Torque& b) {
  return a.world_W == b.world_W && a.body_B == b.body_B && a.rotor_B == b.rotor_B;
}

inline Torque operator+(const Torque& a, const Torque& b) {
  Torque sum;
  sum.world_W = a.world_W + b.world_W;
  sum.body_B = a.body_B + b.body_B;
  sum.rotor_B = a.rotor_B + b.rotor_B;
  return sum;
}

/// A torque as a function of the motion. Must be a pure function: a step may evaluate it several times, at
/// times within the step, on any thread. To combine laws, add their torques:
///
///   TorqueLaw both = [a, b](const TorqueLawInput& motion) { return a(motion) + b(motion); };
using TorqueLaw = std::function<Torque(const TorqueLawInput&)>;

/// The order of convergence in dt of a step with a torque law, if the scheme's own order allows it. Schemes
/// of order 1 evaluate the law once, at the start of the step, with either choice.
enum class TorqueLawOrder {
  /// Evaluates the law once in a step, at its middle (twice in the first step). If the law damps, dt times
  /// its rate must stay below 1.
  two = 2,
  /// Evaluates the law 12 times in a step, 24 times if the torque depends on the velocity.
  four = 4,
};

/// Returns "two" or "four".
std::string_view to_string(TorqueLawOrder order);

}  // namespace polhode
