#pragma once

#include <optional>

#include "polhode/rotation_scheme.h"
#include "polhode/torque_law.h"

/// The step of a body with a torque law or motors: the scheme's free motion D, composed with the kicks K of
/// the torque. K(s) changes the momentum by a torque that acts for the time s, at a fixed orientation:
///
///   L_W <- L_W + s (tau_W + R tau_B),   h <- h + s tau_rotor,   omega_W = I_W^-1 (L_W - R h)
///
///   schemes of order 1    K(dt) D(dt); evaluates the law at the start
///   order two             D(dt/2) K(dt) D(dt/2); evaluates the law once, at the velocity in the middle of K,
///                         which is predicted with the torque of the last step (G. Strang, SIAM J. Numer.
///                         Anal. 5 (1968) 506)
///   order four            D(a_1 dt) K(b_1 dt) D(a_2 dt) ... K(b_6 dt) D(a_7 dt), each K by the classical
///                         Runge-Kutta method (S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313:
///                         S6)
///
/// A motor with constant torque changes h by one half before the step and by the other half after it: of
/// order 2.
namespace polhode {

/// The torque law, rotors and motors of a body.
struct Drive {
  TorqueLaw law;  ///< may be empty
  TorqueLawOrder order = TorqueLawOrder::two;
  std::optional<Torque> last_torque;           ///< torque of the law in the last step
  Vector3 rotor_momentum_B = Vector3::Zero();  ///< RotationState::rotor_momentum_B
  Vector3 rotor_torque_B = Vector3::Zero();    ///< torque of motors on the rotors, N m

  /// Returns true if rotors turn, or a motor will turn them.
  bool has_rotors() const { return !(rotor_momentum_B.isZero(0.0) && rotor_torque_B.isZero(0.0)); }
  /// Returns false if the scheme's own step is enough.
  bool acts() const { return law != nullptr || !rotor_torque_B.isZero(0.0); }
};

/// The start of a step.
struct StepStart {
  double time_s;
  Vector3 position_W;  ///< m
  Vector3 velocity_W;  ///< m/s, constant in the step
};

/// The result of a step. If the law throws, or returns a torque that is not finite or that the scheme does
/// not take, the step is taken without the law.
struct DrivenStep {
  RotationState end;
  std::optional<Torque> last_torque;  ///< for the next step
  bool law_failed;
};

DrivenStep take_driven_step(const RotationScheme& scheme, const StepInput& input, const StepStart& start,
                            const Drive& drive, const RotationState& state) noexcept;

/// Changes by torque law and motors in a step of a body that cannot turn freely, from their torques at the
/// start. Of order 1.
struct DriveGain {
  Vector3 L_W;
  Vector3 rotor_end_B;                ///< RotationState::rotor_momentum_B at the end of the step
  std::optional<Torque> last_torque;  ///< for the next step
  bool law_failed;
};

DriveGain gain_at_start(const RotationScheme& scheme, const StepInput& input, const StepStart& start,
                        const Drive& drive, const RotationState& state) noexcept;

/// Sets the rotors' momentum as motors inside the body do: L_W stays, and the body's velocity changes.
void change_rotor_by_motor(const Vector3& inertia_B, const Vector3& rotor_momentum_B, RotationState& state);

}  // namespace polhode
