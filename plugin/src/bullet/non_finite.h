#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <Eigen/Core>

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

/// The sum of the four numbers of each vector: finite only if they all are.
template <class... Vectors>
btScalar sum_with_padding(const Vectors&... vectors) {
  return (Eigen::Map<const Eigen::Array<btScalar, 4, 1>>(vectors.m_floats) + ...).sum();
}

/// Whether position, velocities, force and torque are finite, by a look that may say no of huge numbers, or
/// of rubbish in the fourth number that Bullet pads vectors with.
inline bool are_surely_finite_but_for_basis(const btRigidBody& body) {
  const btScalar sum =
      sum_with_padding(body.getWorldTransform().getOrigin(), body.getLinearVelocity(),
                       body.getAngularVelocity(), body.getTotalForce(), body.getTotalTorque());
  return sum * btScalar(0.0) == btScalar(0.0);
}

/// Whether pose, velocities, force and torque of the body are all finite.
inline bool is_finite(const btRigidBody& body) {
  const btMatrix3x3& basis = body.getWorldTransform().getBasis();
  const btScalar basis_sum = sum_with_padding(basis[0], basis[1], basis[2]);
  if (are_surely_finite_but_for_basis(body) && basis_sum * btScalar(0.0) == btScalar(0.0)) return true;
  return are_finite(body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity(),
                    body.getTotalForce(), body.getTotalTorque());
}

/// The motion of a body as Bullet holds it.
struct Motion {
  btTransform pose = btTransform::getIdentity();
  btVector3 linear_velocity = btVector3(0, 0, 0);
  btVector3 omega_W = btVector3(0, 0, 0);
};

Motion motion_of(const btRigidBody& body);

/// The body's position, orientation and velocities, each taken from `fallback` if it is not finite.
Motion finite_motion(const btRigidBody& body, const Motion& fallback);

/// Sets the body to its finite_motion, drops a force that is not finite, and switches the body on again if
/// Bullet switched it off over a bounding box of NaN.
void mend(btRigidBody& body, const Motion& fallback);

/// Forgets the body's contact points: the impulses they keep for warm starting may be NaN and would bring it
/// back.
void forget_contacts(btDispatcher& dispatcher, const btRigidBody& body);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
