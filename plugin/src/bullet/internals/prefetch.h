#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstddef>

#include "polhode/bullet/precision.h"

/// Prefetches data that a loop will need some bodies later. Bullet's bodies are scattered in memory, and each
/// spans many cache lines.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Prefetches the cache lines from `first` up to `end`.
inline void prefetch(const void* first, const void* end) {
#if defined(__GNUC__)
  constexpr std::size_t kLine = 64;
  for (const char* at = static_cast<const char*>(first); at < end; at += kLine) __builtin_prefetch(at);
#endif
}

/// @name Parts of a btRigidBody, by the layout of Bullet 3.24
/// @{
/// Includes the activation state, which is stored some members after the interpolated pose.
inline void prefetch_poses(const btRigidBody& body) {
  prefetch(&body.getWorldTransform(), &body.getWorldTransform() + 4);
}
inline void prefetch_velocities(const btRigidBody& body) {
  prefetch(&body.getInvInertiaTensorWorld(), &body.getAngularVelocity() + 1);
}
/// Covers the members from the velocities to the angular factor.
inline void prefetch_dynamics(const btRigidBody& body) {
  prefetch(&body.getLinearVelocity(), &body.getAngularFactor() + 1);
}
/// Covers the flags and the pointer to the motion state.
inline void prefetch_flags(const btRigidBody& body) {
  const auto* end = reinterpret_cast<const char*>(&body.getAngularFactor() - 2);
  prefetch(end - 2 * sizeof(int), end);
}
inline void prefetch_for_motion_state(const btRigidBody& body) {
  const btTransform* interpolated = &body.getInterpolationWorldTransform();
  prefetch(interpolated, interpolated + 3);
  prefetch_flags(body);
}
/// @}

/// Covers the bodies, at the start, and the number of contact points, at the end.
inline void prefetch(const btPersistentManifold& manifold) {
  prefetch(&manifold, &manifold.getContactPoint(0));
  prefetch(&manifold.m_companionIdA, &manifold + 1);
}

/// Assumes that the pose comes first, as in Bullet's motion state; the application's may have any layout.
inline void prefetch_motion_state(const btRigidBody& body) {
  const auto* first = reinterpret_cast<const char*>(body.getMotionState());
  if (first != nullptr) prefetch(first, first + sizeof(btTransform));
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
