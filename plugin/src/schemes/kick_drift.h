#pragma once

#include "polhode/rotation_math.h"
#include "polhode/rotation_scheme.h"

/// The step of the schemes that turn a body at constant momentum: kick, drift, read the velocity back.
///
///   L_W <- L_W + I_W(q_t) delta_omega_W                    kick: contacts, joints, whatever the solver did
///   q_{t+1} = free motion from q_t at L_W over turn_dt     drift
///   omega_W = I_W(q_{t+1})^-1 L_W
///
/// A torque that acts alone is known in full: one half of it is kicked before the drift and the other half
/// after it, in the axes it then has, which is of order 2 for torques constant in the world or in the body
/// (Strang splitting). An impulse of contacts or joints acts in full before the drift: the solver chose it so
/// that the drift does not break them.
namespace polhode::schemes {

/// I_W(q_t) delta_omega_W
inline Vector3 kick_W(const StepInput& input, const RotationState& start) {
  const Vector3 delta_omega_B = start.R_WB.transpose() * input.delta_omega_W;
  return start.R_WB * input.inertia_B.cwiseProduct(delta_omega_B);
}

/// Half the impulse of a torque that acts alone, in the axes of the state.
inline Vector3 half_impulse_W(const StepInput& input, const Matrix3& R_start_WB, const RotationState& state) {
  const Vector3 half_W = 0.5 * input.dt * input.torque_W;
  if (!input.torque_turns_with_body) return half_W;
  return state.R_WB * (R_start_WB.transpose() * half_W);
}

/// `drift(L_W)` turns the state's orientation by free motion at that momentum.
template <class Drift>
void kick_and_drift(const StepInput& input, RotationState& state, Drift drift) {
  Vector3 L_W = state.L_W;
  // In single precision a torque may be too weak to change Bullet's velocity; here it still counts.
  if (!input.torque_W.isZero(0.0)) {
    const Matrix3 R_start_WB = state.R_WB;
    L_W += half_impulse_W(input, R_start_WB, state);
    drift(L_W);
    L_W += half_impulse_W(input, R_start_WB, state);
  } else {
    if (!input.delta_omega_W.isZero(0.0)) L_W += kick_W(input, state);
    drift(L_W);
  }
  set_angular_momentum(state, input.inertia_B, L_W);
}

/// The same for a scheme whose drift is a turn of the body that depends on the momentum in body axes:
/// q_{t+1} = q_t turn_B(inertia_B, L_B, turn_dt).
template <class Turn>
void kick_and_turn(const StepInput& input, RotationState& state, Turn turn_B) {
  kick_and_drift(input, state, [&](const Vector3& L_W) {
    if (L_W.isZero(0.0)) return;  // a body at rest keeps its orientation to the last bit
    const Quaternion rho_B = turn_B(input.inertia_B, Vector3(state.R_WB.transpose() * L_W), input.turn_dt);
    set_orientation(state, (state.q_WB * rho_B).normalized());
  });
}

}  // namespace polhode::schemes
