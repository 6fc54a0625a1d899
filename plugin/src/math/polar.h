#pragma once

#include <limits>

#include "math/rotation.h"

/// Computes the rotation nearest to a matrix R: U V^T of R = U S V^T, the orthogonal factor of its polar
/// decomposition. Real is double or Wide.
///
///   Y <- (sqrt(3)/2) (Y/|Y| + C/|C|),  C = det(Y) Y^-T the cofactors of Y, |.| the Frobenius norm
///   until Y is nearly orthogonal, then
///   Y <- Y + Y (1 - Y^T Y)/2           twice
///
/// The first iteration is Newton's for the polar factor with Frobenius scaling, Y <- (g Y + (g Y)^-T)/2 with
/// g^2 = |Y^-1|/|Y|, times a number that the next scaling removes. It avoids dividing by det(Y), which may be
/// zero. The second iteration is Newton's with Schulz' approximation of the inverse, which needs no division.
///
/// Source: N. J. Higham, SIAM J. Sci. Stat. Comput. 7 (1986) 1160, section 3; Functions of Matrices (2008),
/// section 8.3.
namespace polhode::formulas {

// As 1 - cosine of the angle between Y and C: the singular values are within 1 +- 0.009. The next iteration
// makes that 1 +- 4e-5, and the two after that 1e-9 and rounding.
inline constexpr double kNearlyOrthogonal = 5e-5;
// Below this cosine, det(Y) < 0 is not due to rounding.
inline constexpr double kReflected = -1e-3;
// A condition number of 1e12 takes 6 iterations.
inline constexpr int kMostIterations = 20;

template <class Real>
struct PolarIterate {
  Matrix<Real> Y;
  Real deviation;  ///< 1 - cosine of the angle between the previous Y and its C
};

/// Replaces a matrix with det < 0, whose polar factor is not a rotation, by its negative.
template <class Real>
PolarIterate<Real> newton_iterate(const Matrix<Real>& Y) {
  using std::sqrt;
  const Matrix<Real> C = cofactors(Y);
  const Real per_Y = 1.0 / sqrt(Y.squaredNorm());
  const Real per_C = 1.0 / sqrt(C.squaredNorm());
  const Real cosine = 3.0 * Y.col(0).dot(C.col(0)) * per_Y * per_C;  // Y : C = 3 det(Y)
  const Real sign = select(cosine < kReflected, Real(-1.0), Real(1.0));
  const double half_length = 0.5 * std::sqrt(3.0);
  return {Y * (sign * half_length * per_Y) + C * (half_length * per_C), 1.0 - sign * cosine};
}

template <class Real>
Matrix<Real> schulz_iterate(const Matrix<Real>& Y) {
  const Matrix<Real> missing = Matrix<Real>::Identity() - Y.transpose() * Y;
  return Y + (0.5 * Y) * missing;
}

template <class Real>
Matrix<Real> polar_factor(const Matrix<Real>& R) {
  Matrix<Real> Y = R;
  auto done = R.squaredNorm() < 0.0;  // false in all lanes
  for (int i = 0; i < kMostIterations && !all(done); ++i) {
    const PolarIterate<Real> next = newton_iterate(Y);
    Y = select(done, Y, next.Y);
    done = done | !(next.deviation > kNearlyOrthogonal);
  }
  return schulz_iterate<Real>(schulz_iterate(Y));
}

/// Returns the row of 4 q q^T with the largest diagonal element, which is 4 q times its largest component.
/// The elements of 4 q q^T are sums of elements of Q.
template <class Real>
Eigen::Matrix<Real, 4, 1> quaternion_row(const Matrix<Real>& Q) {
  using Row = Eigen::Matrix<Real, 4, 1>;  // x, y, z, w
  const Real wx = Q(2, 1) - Q(1, 2), wy = Q(0, 2) - Q(2, 0), wz = Q(1, 0) - Q(0, 1);
  const Real xy = Q(0, 1) + Q(1, 0), yz = Q(1, 2) + Q(2, 1), zx = Q(2, 0) + Q(0, 2);
  const Row squares(1.0 + Q(0, 0) - Q(1, 1) - Q(2, 2), 1.0 - Q(0, 0) + Q(1, 1) - Q(2, 2),
                    1.0 - Q(0, 0) - Q(1, 1) + Q(2, 2), 1.0 + Q(0, 0) + Q(1, 1) + Q(2, 2));
  const Row rows[] = {Row(squares[0], xy, zx, wx), Row(xy, squares[1], yz, wy), Row(zx, yz, squares[2], wz)};
  Row best(wx, wy, wz, squares[3]);
  Real largest = squares[3];
  for (int i = 0; i < 3; ++i) {
    const auto larger = squares[i] > largest;
    largest = select(larger, squares[i], largest);
    best = select(larger, rows[i], best);
  }
  return best;
}

/// Returns the nearest rotation: of q and -q the one closer to `before`. Returns the identity for a matrix of
/// rank 1 or 0, or if its squares overflow.
template <class Real>
UnitQuaternion<Real> nearest_rotation(const Matrix<Real>& R, const UnitQuaternion<Real>& before) {
  using std::sqrt;
  const Eigen::Matrix<Real, 4, 1> row = quaternion_row(polar_factor(R));
  const Real length2 = row.squaredNorm();
  const Real length = sqrt(length2);
  const Real signed_length = select(row.dot(before.coeffs()) < Real(0.0), -length, length);
  const auto found = (length2 > Real(0.0)) & (length2 < Real(std::numeric_limits<double>::infinity()));
  const Eigen::Matrix<Real, 4, 1> identity(Real(0.0), Real(0.0), Real(0.0), Real(1.0));
  return UnitQuaternion<Real>(select(found, Eigen::Matrix<Real, 4, 1>(row / signed_length), identity));
}

}  // namespace polhode::formulas
