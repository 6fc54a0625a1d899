#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstring>

namespace polhode::testing {

inline bool same_bits(const btVector3& a, const btVector3& b) {
  return std::memcmp(a.m_floats, b.m_floats, 3 * sizeof(btScalar)) == 0;
}

/// Returns true if pose and velocities are bit-identical.
inline bool same_bits(const btRigidBody& a, const btRigidBody& b) {
  const btTransform& pose_a = a.getWorldTransform();
  const btTransform& pose_b = b.getWorldTransform();
  for (int row = 0; row < 3; ++row) {
    if (!same_bits(pose_a.getBasis()[row], pose_b.getBasis()[row])) return false;
  }
  return same_bits(pose_a.getOrigin(), pose_b.getOrigin()) &&
         same_bits(a.getLinearVelocity(), b.getLinearVelocity()) &&
         same_bits(a.getAngularVelocity(), b.getAngularVelocity());
}

}  // namespace polhode::testing
