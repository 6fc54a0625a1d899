#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstddef>

#include "polhode/bullet/precision.h"

/// Asks for what a loop will need some bodies later: Bullet's bodies are scattered, and each is many lines of
/// the cache.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// From `first` to before `end`.
inline void prefetch(const void* first, const void* end) {
#if defined(__GNUC__)
  constexpr std::size_t kLine = 64;
  for (const char* at = static_cast<const char*>(first); at < end; at += kLine) __builtin_prefetch(at);
#endif
}

/// @name Parts of a btRigidBody, in its order of Bullet 3.24
/// @{
/// With the activation state, which follows the interpolated pose at a distance.
inline void prefetch_poses(const btRigidBody& body) {
  prefetch(&body.getWorldTransform(), &body.getWorldTransform() + 4);
}
inline void prefetch_velocities(const btRigidBody& body) {
  prefetch(&body.getInvInertiaTensorWorld(), &body.getAngularVelocity() + 1);
}
/// From the velocities to the angular factor.
inline void prefetch_dynamics(const btRigidBody& body) {
  prefetch(&body.getLinearVelocity(), &body.getAngularFactor() + 1);
}
/// The flags, and the pointer to the motion state.
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

/// Its bodies, at the start, and its number of contact points, at the end.
inline void prefetch(const btPersistentManifold& manifold) {
  prefetch(&manifold, &manifold.getContactPoint(0));
  prefetch(&manifold.m_companionIdA, &manifold + 1);
}

/// A motion state of the application's may be of any size; the pose of Bullet's is at its start.
inline void prefetch_motion_state(const btRigidBody& body) {
  const auto* first = reinterpret_cast<const char*>(body.getMotionState());
  if (first != nullptr) prefetch(first, first + sizeof(btTransform));
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
