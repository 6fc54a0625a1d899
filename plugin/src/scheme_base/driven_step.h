#pragma once

#include <optional>

#include "polhode/rotation_scheme.h"
#include "polhode/torque_law.h"

/// The step of a body that a torque law or motors drive: the scheme's free motion D, composed with the kicks K of the
/// torque. K(s) is the change of momentum in the time s where the body stands:
///
///   L_W <- L_W + s (tau_W + R tau_B),   h <- h + s tau_rotor,   omega_W = I_W^-1 (L_W - R h)
///
///   schemes of order 1    K(dt) D(dt), the law asked at the start
///   order two             D(dt/2) K(dt) D(dt/2), the law asked once, for the velocity in the middle of K, which is
///                         foretold with the torque of the step before (G. Strang, SIAM J. Numer. Anal. 5 (1968) 506)
///   order four            D(a_1 dt) K(b_1 dt) D(a_2 dt) ... K(b_6 dt) D(a_7 dt), each K by the classical
///                         Runge-Kutta method (S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313: S6)
///
/// A motor of constant torque changes h by one half before the step and by the other after it: of order 2.
namespace polhode {

/// What drives a body, and what of it changes with time.
struct Drive {
  TorqueLaw law;  ///< may be empty
  TorqueLawOrder order = TorqueLawOrder::two;
  std::optional<Torque> last_torque;           ///< of the law
  Vector3 rotor_momentum_B = Vector3::Zero();  ///< RotationState::rotor_momentum_B
  Vector3 rotor_torque_B = Vector3::Zero();    ///< of motors, on the rotors, N m

  /// Rotors that turn, or that a motor will turn.
  bool has_rotors() const { return !(rotor_momentum_B.isZero(0.0) && rotor_torque_B.isZero(0.0)); }
  /// False: the scheme's own step will do.
  bool acts() const { return law != nullptr || !rotor_torque_B.isZero(0.0); }
};

/// The start of a step.
struct StepStart {
  double time_s;
  Vector3 position_W;  ///< m
  Vector3 velocity_W;  ///< m/s, constant in the step
};

/// Where the law throws, or returns something that is not finite or that the scheme cannot take, the step is taken
/// without it.
struct DrivenStep {
  RotationState end;
  std::optional<Torque> last_torque;  ///< for the next step
  bool law_failed;
};

DrivenStep take_driven_step(const RotationScheme& scheme, const StepInput& input, const StepStart& start,
                            const Drive& drive, const RotationState& state) noexcept;

/// What a torque of the start changes in a step of a body that may not turn freely: the sum of law and motors, of
/// order 1.
struct DriveGain {
  Vector3 L_W;
  Vector3 rotor_end_B;                ///< RotationState::rotor_momentum_B at the end
  std::optional<Torque> last_torque;  ///< for the next step
  bool law_failed;
};

DriveGain gain_at_start(const RotationScheme& scheme, const StepInput& input, const StepStart& start,
                        const Drive& drive, const RotationState& state) noexcept;

/// Gives the rotors another momentum by motors inside the body: L_W stays, and the body's velocity changes.
void change_rotor_by_motor(const Vector3& inertia_B, const Vector3& rotor_momentum_B, RotationState& state);

}  // namespace polhode
