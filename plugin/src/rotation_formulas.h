#pragma once

#include <algorithm>
#include <cmath>

#include "lanes/lanes.h"
#include "polhode/rotation_math.h"

/// The formulas of rotation_math.h, and what the schemes need besides, for `Real` = double (one body) or
/// Lanes (eight of them). Frames and units as there.
namespace polhode::formulas {

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using Matrix = Eigen::Matrix<Real, 3, 3>;
template <class Real>
using UnitQuaternion = Eigen::Quaternion<Real, Eigen::DontAlign>;

template <class Derived>
UnitQuaternion<typename Derived::Scalar> normalized(const Eigen::QuaternionBase<Derived>& q) {
  using std::sqrt;
  return UnitQuaternion<typename Derived::Scalar>(q.coeffs() / sqrt(q.coeffs().squaredNorm()));
}

/// det(M) M^-T: its columns are the cross products of M's.
template <class Real>
Matrix<Real> cofactors(const Matrix<Real>& M) {
  Matrix<Real> result;
  result.col(0) = M.col(1).cross(M.col(2));
  result.col(1) = M.col(2).cross(M.col(0));
  result.col(2) = M.col(0).cross(M.col(1));
  return result;
}

/// I_W v with I_W = R I_B R^T, for a rotation.
template <class Real>
Vector<Real> times_inertia_W(const Matrix<Real>& R_WB, const Vector<Real>& inertia_B,
                             const Vector<Real>& v_W) {
  return R_WB * inertia_B.cwiseProduct(R_WB.transpose() * v_W);
}

/// For any R_WB. Summed over the body's axes from first to last: Eigen would add the last two first, and of a
/// body with L in the diagonal of y and z (the handout's) it would by that symmetry hide what rounding does.
template <class Real>
Matrix<Real> inverse_inertia_W(const Matrix<Real>& R_WB, const Vector<Real>& inertia_B) {
  const Matrix<Real> scaled = R_WB * inertia_B.cwiseInverse().asDiagonal();
  const Matrix<Real> of_two =
      scaled.col(0) * R_WB.col(0).transpose() + scaled.col(1) * R_WB.col(1).transpose();
  return of_two + scaled.col(2) * R_WB.col(2).transpose();
}

/// I_W^-1 v with I_W^-1 = R I_B^-1 R^T, for any R_WB. R (I^-1 (R^T v)), not (R I^-1 R^T) v: where the moments
/// differ by orders of magnitude the matrix loses digits.
template <class Real>
Vector<Real> times_inverse_inertia_W(const Matrix<Real>& R_WB, const Vector<Real>& inertia_B,
                                     const Vector<Real>& v_W) {
  return R_WB * Vector<Real>(R_WB.transpose() * v_W).cwiseQuotient(inertia_B);
}

/// M^-T
template <class Real>
Matrix<Real> inverse_transposed(const Matrix<Real>& M) {
  const Matrix<Real> C = cofactors(M);
  return C * (1.0 / M.col(0).dot(C.col(0)));
}

template <class Real>
Vector<Real> angular_momentum_W(const Matrix<Real>& R_WB, const Vector<Real>& inertia_B,
                                const Vector<Real>& omega_W) {
  // (R I^-1 R^T)^-1 = R^-T I R^-1; for a rotation the same as R I R^T.
  return times_inertia_W(inverse_transposed(R_WB), inertia_B, omega_W);
}

template <class Real>
UnitQuaternion<Real> turn_by_euler(const UnitQuaternion<Real>& q_WB, const Vector<Real>& omega_W,
                                   const Real& dt) {
  // q* = q + dt/2 [0, omega] q;  q <- q*/|q*|
  const auto rate = UnitQuaternion<Real>(Real(0.0), omega_W.x(), omega_W.y(), omega_W.z()) * q_WB;
  return normalized(UnitQuaternion<Real>(q_WB.coeffs() + rate.coeffs() * (0.5 * dt)));
}

template <class Real>
UnitQuaternion<Real> turn_like_bullet(const UnitQuaternion<Real>& q_WB, const Vector<Real>& omega_W,
                                      const Real& dt) {
  using std::cos, std::max, std::min, std::sin, std::sqrt;
  const Real speed = sqrt(omega_W.squaredNorm());
  const Real half_angle = 0.5 * min(Real(speed * dt), Real(kBulletTurnLimit));
  // Bullet keeps the axis' length |omega| / omega_c past the limit and then normalises.
  const Real length = max(Real(1.0), Real(speed * dt / kBulletTurnLimit)) * sin(half_angle);
  const Vector<Real> vector = omega_W * (length / speed);
  const UnitQuaternion<Real> turned =
      normalized(UnitQuaternion<Real>(cos(half_angle), vector.x(), vector.y(), vector.z()) * q_WB);
  // At rest the axis is 0/0.
  return UnitQuaternion<Real>(select(speed == Real(0.0), q_WB.coeffs(), turned.coeffs()));
}

template <class Real>
Vector<Real> implicit_gyroscopic_change_B(const Vector<Real>& inertia_B, const Vector<Real>& omega_B,
                                          const Real& dt) {
  // With the moments' differences g, f(omega) = dt omega x I omega is g_x omega_y omega_z and so on round. In
  // them J = I + dt ([omega] I - [I omega]) is I + df/d omega, without cancellation.
  const Vector<Real> g = dt * Vector<Real>(inertia_B.z() - inertia_B.y(), inertia_B.x() - inertia_B.z(),
                                           inertia_B.y() - inertia_B.x());
  const Real &x = omega_B.x(), &y = omega_B.y(), &z = omega_B.z();
  const Vector<Real> residual(g.x() * (y * z), g.y() * (z * x), g.z() * (x * y));
  Matrix<Real> jacobian;
  jacobian.col(0) = Vector<Real>(inertia_B.x(), g.y() * z, g.z() * y);
  jacobian.col(1) = Vector<Real>(g.x() * z, inertia_B.y(), g.z() * x);
  jacobian.col(2) = Vector<Real>(g.x() * y, g.y() * x, inertia_B.z());
  // J delta = -f by Cramer's rule, and once more for what it leaves: by itself it is not accurate where J is
  // nearly singular.
  const Matrix<Real> inverse = inverse_transposed(jacobian).transpose();
  const Vector<Real> change = -(inverse * residual);
  return change - inverse * (jacobian * change + residual);
}

template <class Real>
Vector<Real> implicit_gyroscopic_change_W(const Matrix<Real>& R_WB, const Vector<Real>& inertia_B,
                                          const Vector<Real>& omega_W, const Real& dt) {
  const Vector<Real> omega_B = R_WB.transpose() * omega_W;
  return R_WB * implicit_gyroscopic_change_B(inertia_B, omega_B, dt);
}

}  // namespace polhode::formulas
