#pragma once

#include <LinearMath/btMatrix3x3.h>
#include <LinearMath/btQuaternion.h>
#include <LinearMath/btVector3.h>

#include "polhode/rotation_state.h"

/// Converts between the scenario's doubles and Bullet's own precision.
namespace polhode::demos {

inline btVector3 to_bullet(const Vector3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

inline btQuaternion to_bullet(const Quaternion& q) {
  return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
          static_cast<btScalar>(q.w())};
}

inline Vector3 from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

inline Quaternion from_bullet(const btQuaternion& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

inline Matrix3 from_bullet(const btMatrix3x3& m) {
  Matrix3 result;
  for (int row = 0; row < 3; ++row) result.row(row) = from_bullet(m[row]).transpose();
  return result;
}

}  // namespace polhode::demos
