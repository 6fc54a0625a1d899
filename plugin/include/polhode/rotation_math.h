#pragma once

#include "polhode/rotation_state.h"

/// The rotation mathematics that schemes share, built-in and user-written ones alike. SI units; frames as in
/// rotation_state.h. `R_WB` may be any invertible matrix where a comment says so, else it is a rotation.
namespace polhode {

/// Returns the matrix [v] with [v] u = v x u (handout eq. 2).
Matrix3 skew(const Vector3& v);

/// Returns I_W^-1 = R I_B^-1 R^T, for any R_WB (handout, problem 1, step 1). kg^-1 m^-2.
Matrix3 inverse_inertia_W(const Matrix3& R_WB, const Vector3& inertia_B);

/// Returns L_W = I_W omega_W with I_W the inverse of inverse_inertia_W, for any invertible R_WB. An inertia
/// of 0 on an axis contributes nothing.
Vector3 angular_momentum_W(const Matrix3& R_WB, const Vector3& inertia_B, const Vector3& omega_W);

/// Returns the rotation by |v| radians about v: (cos |v|/2, sin(|v|/2) v/|v|), by its series near v = 0.
Quaternion exponential(const Vector3& v);

/// Inverts exponential: returns the shortest rotation vector of q, |v| <= pi.
Vector3 logarithm(const Quaternion& q);

/// Makes one Euler step of the orientation, q + (dt/2) [0, omega_W] q, normalized (handout eq. 3).
Quaternion turn_by_euler(const Quaternion& q_WB, const Vector3& omega_W, double dt);

/// Turns as Bullet does in one step: by the exponential map up to pi/4, beyond it by 2 atan((|omega|/omega_c)
/// tan(pi/8)) with omega_c = pi/(4 dt) (btTransformUtil::integrateTransform, Bullet 3.24).
Quaternion turn_like_bullet(const Quaternion& q_WB, const Vector3& omega_W, double dt);

/// The angle in one step beyond which turn_like_bullet turns too little, rad.
inline constexpr double kBulletTurnLimit = 0.78539816339744831;  // pi/4

/// Returns the change of omega_B that the gyroscopic torque makes in dt, by one Newton step of implicit Euler
/// from omega_B (handout eq. 7-9), of a body without rotors.
Vector3 implicit_gyroscopic_change_B(const Vector3& inertia_B, const Vector3& omega_B, double dt);

/// Returns the same change in world axes, for a state without rotors whose R_WB is a rotation (handout eq. 10).
Vector3 implicit_gyroscopic_change_W(const RotationState& state, const Vector3& inertia_B, double dt);

/// Makes `q_WB` the state's orientation, R_WB with it.
void set_orientation(RotationState& state, const Quaternion& q_WB);

/// Returns I_W omega_W for a total angular momentum of L_W: L_W - R h with the state's rotors.
Vector3 without_rotor(const RotationState& state, const Vector3& L_W);

/// Returns the total angular momentum for an I_W omega_W: the same plus R h.
Vector3 with_rotor(const RotationState& state, const Vector3& body_momentum_W);

/// Sets omega_W, and L_W to agree with it at the state's R_WB (a rotation).
void set_omega(RotationState& state, const Vector3& inertia_B, const Vector3& omega_W);

/// Sets L_W, and omega_W to agree with it at the state's R_WB (any matrix).
void set_angular_momentum(RotationState& state, const Vector3& inertia_B, const Vector3& L_W);

}  // namespace polhode
