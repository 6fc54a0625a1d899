#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "math/sine_cosine.h"
#include "polhode/rotation_math.h"
#include "simd/wide.h"

/// The formulas of rotation_math.h, and others that the schemes share, for Real = double (one body) or Wide
/// (eight bodies). Frames and units as there.
namespace polhode::formulas {

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using Matrix = Eigen::Matrix<Real, 3, 3>;
template <class Real>
using UnitQuaternion = Eigen::Quaternion<Real, Eigen::DontAlign>;

/// Returns |v|^2, summed from first to last: Eigen's order differs between double and other types.
template <class Real>
Real squared_length(const Vector<Real>& v) {
  return v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
}

template <class Derived>
UnitQuaternion<typename Derived::Scalar> normalized(const Eigen::QuaternionBase<Derived>& q) {
  using std::sqrt;
  return UnitQuaternion<typename Derived::Scalar>(q.coeffs() / sqrt(q.coeffs().squaredNorm()));
}

/// Returns det(M) M^-T, whose columns are the cross products of M's columns.
template <class Real>
Matrix<Real> cofactors(const Matrix<Real>& M) {
  Matrix<Real> result;
  result.col(0) = M.col(1).cross(M.col(2));
  result.col(1) = M.col(2).cross(M.col(0));
  result.col(2) = M.col(0).cross(M.col(1));
  return result;
}

/// Returns I_W v with I_W = R I_B R^T, for a rotation.
template <class Real>
Vector<Real> times_inertia_W(const Matrix<Real>& R_WB, const Vector<Real>& inertia_B,
                             const Vector<Real>& v_W) {
  return R_WB * inertia_B.cwiseProduct(R_WB.transpose() * v_W);
}

/// Works for any R_WB. Sums over the body axes from first to last. Eigen would add the last two first; for L
/// in the diagonal of y and z (as in the handout), this symmetry would hide the effect of rounding.
template <class Real>
Matrix<Real> inverse_inertia_W(const Matrix<Real>& R_WB, const Vector<Real>& inertia_B) {
  const Matrix<Real> scaled = R_WB * inertia_B.cwiseInverse().asDiagonal();
  const Matrix<Real> of_two =
      scaled.col(0) * R_WB.col(0).transpose() + scaled.col(1) * R_WB.col(1).transpose();
  return of_two + scaled.col(2) * R_WB.col(2).transpose();
}

/// Returns I_W^-1 v with I_W^-1 = R I_B^-1 R^T, for any R_WB. Computed as R (I^-1 (R^T v)): the matrix
/// R I^-1 R^T loses digits if the moments differ by orders of magnitude.
template <class Real>
Vector<Real> times_inverse_inertia_W(const Matrix<Real>& R_WB, const Vector<Real>& inertia_B,
                                     const Vector<Real>& v_W) {
  return R_WB * Vector<Real>(R_WB.transpose() * v_W).cwiseQuotient(inertia_B);
}

/// Returns M^-T.
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

/// Returns the matrix [v] with [v] u = v x u (handout eq. 2).
template <class Real>
Matrix<Real> skew(const Vector<Real>& v) {
  const Real zero(0.0);
  Matrix<Real> m;
  m.row(0) << zero, -v.z(), v.y();
  m.row(1) << v.z(), zero, -v.x();
  m.row(2) << -v.y(), v.x(), zero;
  return m;
}

/// Solves M x = b by Cramer's rule, with one refinement by the residual for a nearly singular M.
template <class Real>
Vector<Real> solve(const Matrix<Real>& M, const Vector<Real>& b) {
  const Matrix<Real> inverse = inverse_transposed(M).transpose();
  const Vector<Real> x = inverse * b;
  return x + inverse * (b - M * x);
}

/// Returns the rotation by |v| radians about v, for any v. Error: one ulp of 1 and of |v|. Same bits for
/// double and Wide.
template <class Real>
UnitQuaternion<Real> exponential(const Vector<Real>& v) {
  using std::sqrt;
  // Below this angle sin(x/2)/x is 1/2 - x^2/48 + x^4/3840; the first omitted term is below 1e-24.
  constexpr double kSeriesAngle = 1e-3;
  const Real angle2 = squared_length(v);
  const Real angle = sqrt(angle2);
  const auto [sine, cosine] = sine_cosine(Real(0.5 * angle));
  const Real series = 0.5 - angle2 * (1.0 / 48.0 - angle2 / 3840.0);
  const Real half_sinc = select(angle < kSeriesAngle, series, Real(sine / angle));
  return {cosine, half_sinc * v.x(), half_sinc * v.y(), half_sinc * v.z()};
}

/// Returns asin(s)/s from s^2 <= 0.05; the omitted terms are below 1e-18.
template <class Real>
POLHODE_INLINE Real arc_sine_series(const Real& s2) {
  // kArcSine[i] is the coefficient of s^(2i).
  constexpr std::array<double, 13> kArcSine = {1.0,
                                               1.0 / 6.0,
                                               3.0 / 40.0,
                                               5.0 / 112.0,
                                               35.0 / 1152.0,
                                               63.0 / 2816.0,
                                               231.0 / 13312.0,
                                               143.0 / 10240.0,
                                               6435.0 / 557056.0,
                                               12155.0 / 1245184.0,
                                               46189.0 / 5505024.0,
                                               88179.0 / 12058624.0,
                                               676039.0 / 104857600.0};
  const Real s4 = s2 * s2;
  const Real s6 = s2 * s4;
  const auto every_third_term = [&s6, &kArcSine](std::size_t first) {
    Real sum = kArcSine[first + 9];
    for (std::size_t i = first + 9; i >= 3; i -= 3) sum = sum * s6 + kArcSine[i - 3];
    return sum;
  };
  // Three independent sums, so that none waits for another.
  const Real first = every_third_term(0) + (s6 * s6) * (s6 * s6) * kArcSine[12];
  return first + (s2 * every_third_term(1) + s4 * every_third_term(2));
}

/// Returns the shortest rotation vector of q, |v| <= pi: the inverse of `exponential`. Same bits for double
/// and Wide.
template <class Real>
Vector<Real> logarithm(const UnitQuaternion<Real>& q) {
  using std::abs, std::sqrt;
  // Halves h = half the angle three times: sin(x/2) = sin(x)/(2 cos(x/2)), cos(x/2) = sqrt((1 + cos(x))/2).
  // h <= pi/2, so sin^2(h/8) <= 0.0381.
  Real sine2 = squared_length<Real>(q.vec());
  Real cosine = abs(q.w());
  Real cosines = 1.0;
  for (int i = 0; i < 3; ++i) {
    const Real cosine2 = 0.5 + 0.5 * cosine;
    cosine = sqrt(cosine2);
    cosines *= cosine;
    sine2 = sine2 / (4.0 * cosine2);
  }
  const Real factor = 2.0 * arc_sine_series(sine2) / cosines;
  return q.vec() * select(q.w() < 0.0, Real(-factor), factor);
}

/// Returns exp(omega dt) q, or q itself at velocity 0.
template <class Real>
UnitQuaternion<Real> turn_exponentially(const UnitQuaternion<Real>& q_WB, const Vector<Real>& omega_W,
                                        const Real& dt) {
  const Vector<Real> turn_W = dt * omega_W;
  const UnitQuaternion<Real> turned = exponential(turn_W) * q_WB;
  // One Newton step normalizes the quaternion.
  const UnitQuaternion<Real> unit(turned.coeffs() * (1.5 - 0.5 * turned.coeffs().squaredNorm()));
  return UnitQuaternion<Real>(select(turn_W.squaredNorm() == 0.0, q_WB.coeffs(), unit.coeffs()));
}

template <class Real>
UnitQuaternion<Real> turn_by_euler(const UnitQuaternion<Real>& q_t, const Vector<Real>& omega_W,
                                   const Real& dt) {
  // (3)  omega' = [0, omega],   q* = q_t + dt/2 omega' q_t,   q_{t+1} = q*/|q*|
  const UnitQuaternion<Real> omega(Real(0.0), omega_W.x(), omega_W.y(), omega_W.z());
  const UnitQuaternion<Real> rate = omega * q_t;
  const UnitQuaternion<Real> q_star(q_t.coeffs() + 0.5 * dt * rate.coeffs());
  return normalized(q_star);
}

/// Mirrors btTransformUtil::integrateTransform of Bullet 3.24, in double precision.
template <class Real>
UnitQuaternion<Real> turn_like_bullet(const UnitQuaternion<Real>& q_WB, const Vector<Real>& omega_W,
                                      const Real& dt) {
  using std::max, std::min, std::sqrt;
  const Real speed = sqrt(omega_W.squaredNorm());
  const Real half_angle = 0.5 * min(Real(speed * dt), Real(kBulletTurnLimit));
  const auto [sine, cosine] = sine_cosine(half_angle);
  // Beyond the limit Bullet keeps the axis' length |omega| / omega_c and then normalizes.
  const Real length = max(Real(1.0), Real(speed * dt / kBulletTurnLimit)) * sine;
  const Vector<Real> vector = omega_W * (length / speed);
  const UnitQuaternion<Real> turned =
      normalized(UnitQuaternion<Real>(cosine, vector.x(), vector.y(), vector.z()) * q_WB);
  // At rest the axis would be 0/0.
  return UnitQuaternion<Real>(select(speed == Real(0.0), q_WB.coeffs(), turned.coeffs()));
}

/// Returns omega x I omega from the differences of the moments: the terms of the cross product itself would
/// cancel.
template <class Real>
Vector<Real> omega_cross_I_omega(const Vector<Real>& inertia_B, const Vector<Real>& omega_B) {
  const Real &I_x = inertia_B.x(), &I_y = inertia_B.y(), &I_z = inertia_B.z();
  const Real &x = omega_B.x(), &y = omega_B.y(), &z = omega_B.z();
  return {(I_z - I_y) * (y * z), (I_x - I_z) * (z * x), (I_y - I_x) * (x * y)};
}

/// Mirrors btRigidBody::computeGyroscopicImpulseImplicit_Body of Bullet 3.24, in double precision.
template <class Real>
Vector<Real> implicit_gyroscopic_change_B(const Vector<Real>& inertia_B, const Vector<Real>& omega_b,
                                          const Real& dt) {
  const Matrix<Real> I_b = inertia_B.asDiagonal();
  const Vector<Real> L_b = inertia_B.cwiseProduct(omega_b);
  // (7)  f(omega_b) = dt omega_b x I_b omega_b
  const Vector<Real> f = dt * omega_cross_I_omega(inertia_B, omega_b);
  // (9)  J = I_b + dt (Omega(omega_b) I_b - Omega(I_b omega_b))
  const Matrix<Real> J = I_b + dt * (skew(omega_b) * I_b - skew(L_b));
  // (8)  J delta_omega_b = -f
  return -solve(J, f);
}

}  // namespace polhode::formulas
