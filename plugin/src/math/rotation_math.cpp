#include "polhode/rotation_math.h"

#include "math/rotation.h"

namespace polhode {

Matrix3 skew(const Vector3& v) {
  return formulas::skew(v);
}

Matrix3 inverse_inertia_W(const Matrix3& R_WB, const Vector3& inertia_B) {
  return formulas::inverse_inertia_W(R_WB, inertia_B);
}

Vector3 angular_momentum_W(const Matrix3& R_WB, const Vector3& inertia_B, const Vector3& omega_W) {
  return formulas::angular_momentum_W(R_WB, inertia_B, omega_W);
}

Quaternion exponential(const Vector3& v) {
  return formulas::exponential(v);
}

Vector3 logarithm(const Quaternion& q) {
  return formulas::logarithm(q);
}

Quaternion turn_by_euler(const Quaternion& q_WB, const Vector3& omega_W, double dt) {
  return formulas::turn_by_euler(q_WB, omega_W, dt);
}

Quaternion turn_like_bullet(const Quaternion& q_WB, const Vector3& omega_W, double dt) {
  return formulas::turn_like_bullet(q_WB, omega_W, dt);
}

Vector3 implicit_gyroscopic_change_B(const Vector3& inertia_B, const Vector3& omega_B, double dt) {
  return formulas::implicit_gyroscopic_change_B(inertia_B, omega_B, dt);
}

Vector3 implicit_gyroscopic_change_W(const RotationState& state, const Vector3& inertia_B, double dt) {
  const Vector3 omega_B = state.R_WB.transpose() * state.omega_W;
  return state.R_WB * formulas::implicit_gyroscopic_change_B(inertia_B, omega_B, dt);
}

void set_orientation(RotationState& state, const Quaternion& q_WB) {
  state.q_WB = q_WB;
  state.R_WB = q_WB.toRotationMatrix();
}

// Without rotors nothing is added, since -0 + 0 would change the sign bit.
Vector3 without_rotor(const RotationState& state, const Vector3& L_W) {
  return state.has_rotor() ? Vector3(L_W - state.R_WB * state.rotor_momentum_B) : L_W;
}

Vector3 with_rotor(const RotationState& state, const Vector3& body_momentum_W) {
  return state.has_rotor() ? Vector3(body_momentum_W + state.R_WB * state.rotor_momentum_B) : body_momentum_W;
}

void set_omega(RotationState& state, const Vector3& inertia_B, const Vector3& omega_W) {
  state.omega_W = omega_W;
  state.L_W = with_rotor(state, formulas::times_inertia_W(state.R_WB, inertia_B, omega_W));
}

void set_angular_momentum(RotationState& state, const Vector3& inertia_B, const Vector3& L_W) {
  state.L_W = L_W;
  state.omega_W = formulas::times_inverse_inertia_W(state.R_WB, inertia_B, without_rotor(state, L_W));
}

}  // namespace polhode
