#pragma once

#include <LinearMath/btMatrix3x3.h>

#include "polhode/bullet/precision.h"
#include "polhode/rotation_state.h"

/// Between Bullet's types, in its precision, and ours. From Bullet to us nothing is lost.
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

inline btVector3 to_bullet(const Vector3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

inline btMatrix3x3 to_bullet(const Matrix3& m) {
  btMatrix3x3 result;
  for (int row = 0; row < 3; ++row) result[row] = to_bullet(Vector3(m.row(row)));
  return result;
}

/// The rotation that a basis of Bullet's stands for.
inline Quaternion to_quaternion(const btMatrix3x3& basis) {
  return Quaternion(to_double(basis)).normalized();
}

/// Equal values in every component; the fourth, which Bullet pads with, does not count.
inline bool same(const btVector3& a, const btVector3& b) {
  return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}

inline bool same(const btMatrix3x3& a, const btMatrix3x3& b) {
  return same(a[0], b[0]) && same(a[1], b[1]) && same(a[2], b[2]);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
