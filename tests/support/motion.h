#pragma once

#include <btBulletDynamicsCommon.h>

#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"

/// Reads a Bullet body's motion, in double precision.
namespace polhode::testing {

inline Matrix3 basis_of(const btRigidBody& body) {
  return to_double(body.getWorldTransform().getBasis());
}

inline Vector3 omega_of(const btRigidBody& body) {
  return to_double(body.getAngularVelocity());
}

/// Returns the rotation vector, in world axes, from one basis to the other, rad.
inline Vector3 turn_between(const Matrix3& from, const Matrix3& to) {
  return logarithm(Quaternion(Matrix3(to * from.inverse())).normalized());
}

inline double angle_between(const Matrix3& a, const Matrix3& b) {
  return turn_between(a, b).norm();
}

/// Returns the largest difference between two elements.
inline double distance(const Matrix3& a, const Matrix3& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// Returns true if pose and velocities are bit-identical.
inline bool same_motion(const btRigidBody& a, const btRigidBody& b) {
  return same(a.getWorldTransform().getBasis(), b.getWorldTransform().getBasis()) &&
         same(a.getWorldTransform().getOrigin(), b.getWorldTransform().getOrigin()) &&
         same(a.getAngularVelocity(), b.getAngularVelocity()) &&
         same(a.getLinearVelocity(), b.getLinearVelocity());
}

/// Returns true if the body has the library's orientation, rounded to Bullet's precision.
inline bool shows_orientation(const btRigidBody& body, const RotationState& state) {
  return same(body.getWorldTransform().getBasis(), to_bullet(state.q_WB.toRotationMatrix()));
}

/// Returns true if the body has the library's orientation and velocity, as every body does outside joints and
/// contacts.
inline bool shows(const btRigidBody& body, const RotationState& state) {
  return shows_orientation(body, state) && same(body.getAngularVelocity(), to_bullet(state.omega_W));
}

inline btVector3 vector(double x, double y, double z) {
  return {static_cast<btScalar>(x), static_cast<btScalar>(y), static_cast<btScalar>(z)};
}

}  // namespace polhode::testing
