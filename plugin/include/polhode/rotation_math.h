#pragma once

#include "polhode/rotation_state.h"

/// Rotation mathematics that schemes share, both built-in and user-written. SI units; frames as in
/// rotation_state.h. `R_WB` is a rotation unless a comment says that it may be any invertible matrix.
namespace polhode {

/// Returns the matrix [v] with [v] u = v x u (handout eq. 2).
Matrix3 skew(const Vector3& v);

/// Returns I_W^-1 = R I_B^-1 R^T for any R_WB (handout, problem 1, step 1), in kg^-1 m^-2.
Matrix3 inverse_inertia_W(const Matrix3& R_WB, const Vector3& inertia_B);

/// Returns L_W = I_W omega_W for any invertible R_WB, with I_W the inverse of inverse_inertia_W. An axis with
/// inertia 0 contributes nothing.
Vector3 angular_momentum_W(const Matrix3& R_WB, const Vector3& inertia_B, const Vector3& omega_W);

/// Returns the rotation by |v| radians about v: (cos |v|/2, sin(|v|/2) v/|v|). Uses the series near v = 0.
Quaternion exponential(const Vector3& v);

/// Returns the shortest rotation vector of q, |v| <= pi rad: the inverse of exponential.
Vector3 logarithm(const Quaternion& q);

/// Returns the orientation after one Euler step: q + (dt/2) [0, omega_W] q, normalized (handout eq. 3).
Quaternion turn_by_euler(const Quaternion& q_WB, const Vector3& omega_W, double dt);

/// Returns the orientation after one Bullet step: the exponential map up to pi/4 rad, beyond it a rotation by
/// 2 atan((|omega|/omega_c) tan(pi/8)) with omega_c = pi/(4 dt) (btTransformUtil::integrateTransform, Bullet
/// 3.24).
Quaternion turn_like_bullet(const Quaternion& q_WB, const Vector3& omega_W, double dt);

/// Angle of one step, in rad, beyond which turn_like_bullet rotates too little.
inline constexpr double kBulletTurnLimit = 0.78539816339744831;  // pi/4

/// Returns the change of omega_B by the gyroscopic torque in dt, in rad/s, for a body without rotors: one
/// Newton step of implicit Euler from omega_B (handout eq. 7-9).
Vector3 implicit_gyroscopic_change_B(const Vector3& inertia_B, const Vector3& omega_B, double dt);

/// Returns the same change in world axes, for a state without rotors (handout eq. 10).
Vector3 implicit_gyroscopic_change_W(const RotationState& state, const Vector3& inertia_B, double dt);

/// Sets q_WB of the state, and R_WB to its matrix.
void set_orientation(RotationState& state, const Quaternion& q_WB);

/// Returns the body's own part of the total angular momentum L_W: I_W omega_W = L_W - R h, h the state's
/// rotors.
Vector3 without_rotor(const RotationState& state, const Vector3& L_W);

/// Returns the total angular momentum of a body whose own part is body_momentum_W = I_W omega_W: the sum with
/// R h.
Vector3 with_rotor(const RotationState& state, const Vector3& body_momentum_W);

/// Sets omega_W, and L_W to match for the state's R_WB (a rotation).
void set_omega(RotationState& state, const Vector3& inertia_B, const Vector3& omega_W);

/// Sets L_W, and omega_W to match for the state's R_WB (any matrix).
void set_angular_momentum(RotationState& state, const Vector3& inertia_B, const Vector3& L_W);

}  // namespace polhode
