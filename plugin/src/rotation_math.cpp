#include "polhode/rotation_math.h"

#include <cmath>

#include "rotation_formulas.h"

namespace polhode {

namespace {

// Below this angle sin(x/2)/x is taken from its series; the first term left out, x^6/645120, is under 1e-24
// here.
constexpr double kSeriesAngle = 1e-3;

// sin(x/2)/x
double half_sinc(double angle) {
  if (angle < kSeriesAngle) {
    const double angle2 = angle * angle;
    return 0.5 - angle2 / 48.0 + angle2 * angle2 / 3840.0;
  }
  return std::sin(0.5 * angle) / angle;
}

Quaternion from_scalar_and_vector(double scalar, const Vector3& vector) {
  return {scalar, vector.x(), vector.y(), vector.z()};
}

}  // namespace

Matrix3 skew(const Vector3& v) {
  Matrix3 m;
  m << 0.0, -v.z(), v.y(),  //
      v.z(), 0.0, -v.x(),   //
      -v.y(), v.x(), 0.0;
  return m;
}

Matrix3 inverse_inertia_W(const Matrix3& R_WB, const Vector3& inertia_B) {
  return formulas::inverse_inertia_W(R_WB, inertia_B);
}

Vector3 angular_momentum_W(const Matrix3& R_WB, const Vector3& inertia_B, const Vector3& omega_W) {
  return formulas::angular_momentum_W(R_WB, inertia_B, omega_W);
}

Quaternion exponential(const Vector3& v) {
  const double angle = v.norm();
  return from_scalar_and_vector(std::cos(0.5 * angle), half_sinc(angle) * v);
}

Vector3 logarithm(const Quaternion& q) {
  const Vector3 vector = q.w() < 0.0 ? Vector3(-q.vec()) : Vector3(q.vec());
  const double sine = vector.norm();
  const double angle = 2.0 * std::atan2(sine, std::abs(q.w()));
  return vector / half_sinc(angle);
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
  return formulas::implicit_gyroscopic_change_W(state.R_WB, inertia_B, state.omega_W, dt);
}

void set_orientation(RotationState& state, const Quaternion& q_WB) {
  state.q_WB = q_WB;
  state.R_WB = q_WB.toRotationMatrix();
}

void set_omega(RotationState& state, const Vector3& inertia_B, const Vector3& omega_W) {
  state.omega_W = omega_W;
  state.L_W = formulas::times_inertia_W(state.R_WB, inertia_B, omega_W);
}

void set_angular_momentum(RotationState& state, const Vector3& inertia_B, const Vector3& L_W) {
  state.L_W = L_W;
  state.omega_W = formulas::times_inverse_inertia_W(state.R_WB, inertia_B, L_W);
}

}  // namespace polhode
