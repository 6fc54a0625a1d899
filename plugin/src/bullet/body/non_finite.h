#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// 0 times a finite number is 0, times any other NaN: one comparison for many numbers.
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

/// Returns whether pose, velocities, force and torque of the body are all finite.
inline bool is_finite(const btRigidBody& body) {
  return are_finite(body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity(),
                    body.getTotalForce(), body.getTotalTorque());
}

/// The motion of a body as Bullet holds it.
struct BodyMotion {
  btTransform pose = btTransform::getIdentity();
  btVector3 linear_velocity = btVector3(0, 0, 0);
  btVector3 omega_W = btVector3(0, 0, 0);
};

/// The body's position, orientation and velocities, each taken from `fallback` if it is not finite.
BodyMotion finite_motion(const btRigidBody& body, const BodyMotion& fallback);

/// Sets the body to its finite_motion, drops a force that is not finite, and switches the body on again if
/// Bullet switched it off over a bounding box of NaN.
void sanitize(btRigidBody& body, const BodyMotion& fallback);

/// Forgets the object's contact points: the impulses they keep for warm starting may be NaN and would bring it
/// back.
void forget_contacts(btDispatcher& dispatcher, const btCollisionObject& object);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
