#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>

/// Makes numbers of an input into what Bullet can take at all.
namespace polhode::fuzz {

bool is_finite(const btVector3& v);
bool is_finite(const btMatrix3x3& m);
/// Pose, velocities and inverse inertia in the world.
bool is_finite(const btRigidBody& body);
/// Pose and velocities.
bool is_finite(const btMultiBody& multibody);

/// A mass or moment whose inverse is a number: no library can turn a body without one. 0 is allowed where it
/// means that the body does not turn about the axis.
btScalar inertia(btScalar x, bool zero_is_allowed);
btVector3 moments(const btVector3& v);

btQuaternion orientation(const btVector3& v, btScalar x);

}  // namespace polhode::fuzz
