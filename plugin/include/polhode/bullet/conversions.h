#pragma once

#include <LinearMath/btTransform.h>

#include "polhode/bullet/precision.h"
#include "polhode/rotation_state.h"

/// Converts between Bullet's types, in Bullet's precision, and Eigen's types in double. Conversion from
/// Bullet is exact; conversion to Bullet rounds. Component order differs: btQuaternion's constructor takes x,
/// y, z, w, Eigen's takes w, x, y, z.
namespace polhode {
inline namespace POLHODE_PRECISION {

inline Vector3 to_double(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

inline Matrix3 to_double(const btMatrix3x3& m) {
  Matrix3 result;
  for (int row = 0; row < 3; ++row) result.row(row) = to_double(m[row]).transpose();
  return result;
}

inline Quaternion to_double(const btQuaternion& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

/// Copies the basis unchanged, even if it is not a rotation.
inline Eigen::Isometry3d to_double(const btTransform& transform) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = to_double(transform.getBasis());
  result.translation() = to_double(transform.getOrigin());
  return result;
}

inline btVector3 to_bullet(const Vector3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

// Converts element by element and in place. A vectorized copy would stall on elements that were just stored
// one by one.
inline void to_bullet(const Matrix3& m, btMatrix3x3& result) {
  const auto rounded = [&m](int row, int column) { return static_cast<btScalar>(m(row, column)); };
  result.setValue(rounded(0, 0), rounded(0, 1), rounded(0, 2), rounded(1, 0), rounded(1, 1), rounded(1, 2),
                  rounded(2, 0), rounded(2, 1), rounded(2, 2));
}

inline btMatrix3x3 to_bullet(const Matrix3& m) {
  btMatrix3x3 result;
  to_bullet(m, result);
  return result;
}

inline btQuaternion to_bullet(const Quaternion& q) {
  return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
          static_cast<btScalar>(q.w())};
}

inline btTransform to_bullet(const Eigen::Isometry3d& pose) {
  return btTransform(to_bullet(Matrix3(pose.linear())), to_bullet(Vector3(pose.translation())));
}

/// Returns the rotation that a Bullet basis represents, normalized.
inline Quaternion to_quaternion(const btMatrix3x3& basis) {
  Matrix3 R = to_double(basis);
  // Scale down numbers too large for a rotation, so that the norm does not overflow.
  constexpr double kLarge = 1e100;
  const double largest = R.cwiseAbs().maxCoeff();
  if (largest > kLarge) R /= largest;
  return Quaternion(R).normalized();
}

/// Returns true if all components are equal. Ignores the fourth component, which is Bullet's padding.
inline bool same(const btVector3& a, const btVector3& b) {
  return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}

inline bool same(const btMatrix3x3& a, const btMatrix3x3& b) {
  int differences = 0;  // one sum instead of nine branches
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) differences += a[row][column] == b[row][column] ? 0 : 1;
  }
  return differences == 0;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
