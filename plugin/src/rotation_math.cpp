#include "polhode/rotation_math.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

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
  return R_WB * inertia_B.cwiseInverse().asDiagonal() * R_WB.transpose();
}

Vector3 angular_momentum_W(const Matrix3& R_WB, const Vector3& inertia_B, const Vector3& omega_W) {
  // (R I^-1 R^T)^-1 = R^-T I R^-1; for a rotation the same as R I R^T.
  const Matrix3 R_BW = R_WB.inverse();
  return R_BW.transpose() * inertia_B.cwiseProduct(R_BW * omega_W);
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
  // q* = q + dt/2 [0, omega] q;  q <- q*/|q*|
  const Quaternion rate = from_scalar_and_vector(0.0, omega_W) * q_WB;
  Quaternion turned;
  turned.coeffs() = q_WB.coeffs() + 0.5 * dt * rate.coeffs();
  return turned.normalized();
}

Quaternion turn_like_bullet(const Quaternion& q_WB, const Vector3& omega_W, double dt) {
  const double speed = omega_W.norm();
  if (speed == 0.0) return q_WB;
  const double half_angle = 0.5 * std::min(speed * dt, kBulletTurnLimit);
  // Bullet keeps the axis' length |omega| / omega_c past the limit and then normalises.
  const double length = std::max(1.0, speed * dt / kBulletTurnLimit) * std::sin(half_angle);
  return (from_scalar_and_vector(std::cos(half_angle), omega_W * (length / speed)) * q_WB).normalized();
}

Vector3 implicit_gyroscopic_change_B(const Vector3& inertia_B, const Vector3& omega_B, double dt) {
  const Vector3 L_B = inertia_B.cwiseProduct(omega_B);
  // f(omega) = dt omega x I omega
  const Vector3 residual = dt * omega_B.cross(L_B);
  // J = I + dt ([omega] I - [I omega])
  Matrix3 jacobian = dt * (skew(omega_B) * inertia_B.asDiagonal() - skew(L_B));
  jacobian.diagonal() += inertia_B;
  // J delta = -f
  return -jacobian.colPivHouseholderQr().solve(residual);
}

Vector3 implicit_gyroscopic_change_W(const RotationState& state, const Vector3& inertia_B, double dt) {
  const Vector3 omega_B = state.R_WB.transpose() * state.omega_W;
  return state.R_WB * implicit_gyroscopic_change_B(inertia_B, omega_B, dt);
}

void set_orientation(RotationState& state, const Quaternion& q_WB) {
  state.q_WB = q_WB;
  state.R_WB = q_WB.toRotationMatrix();
}

void set_omega(RotationState& state, const Vector3& inertia_B, const Vector3& omega_W) {
  state.omega_W = omega_W;
  state.L_W = state.R_WB * inertia_B.cwiseProduct(state.R_WB.transpose() * omega_W);
}

void set_angular_momentum(RotationState& state, const Vector3& inertia_B, const Vector3& L_W) {
  state.L_W = L_W;
  // R (I^-1 (R^T L)), not (R I^-1 R^T) L: where the moments differ by orders of magnitude the matrix loses
  // digits.
  state.omega_W = state.R_WB * Vector3(state.R_WB.transpose() * L_W).cwiseQuotient(inertia_B);
}

}  // namespace polhode
