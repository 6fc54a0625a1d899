#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Returns 0 if all components are finite, otherwise NaN: 0 times infinity or NaN is NaN.
inline btVector3 probe(const btVector3& v) {
  return v * btScalar(0.0);
}

inline btVector3 probe(const btMatrix3x3& basis) {
  return probe(basis[0]) + probe(basis[1]) + probe(basis[2]);
}

inline btVector3 probe(const btTransform& pose) {
  return probe(pose.getOrigin()) + probe(pose.getBasis());
}

template <class... Values>
bool are_finite(const Values&... values) {
  const btVector3 sum = (probe(values) + ...);
  return sum.x() + sum.y() + sum.z() == btScalar(0.0);
}

/// Returns true if pose, velocities, force and torque of the body are all finite.
inline bool is_finite(const btRigidBody& body) {
  return are_finite(body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity(),
                    body.getTotalForce(), body.getTotalTorque());
}

/// Pose and velocities of a body, in Bullet's precision.
struct BodyMotion {
  btTransform pose = btTransform::getIdentity();
  btVector3 linear_velocity = btVector3(0, 0, 0);
  btVector3 omega_W = btVector3(0, 0, 0);
};

/// Returns the body's pose and velocities; each of them is taken from `fallback` if it is not finite.
BodyMotion finite_motion(const btRigidBody& body, const BodyMotion& fallback);

/// Sets the body to its finite_motion, clears forces that are not finite, and reactivates the body if Bullet
/// deactivated it because its bounding box was not finite.
void sanitize(btRigidBody& body, const BodyMotion& fallback);

/// Clears the object's contact points, whose impulses, kept for warm starting, may be NaN.
void forget_contacts(btDispatcher& dispatcher, const btCollisionObject& object);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
