#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>

/// Maps numbers of an input to numbers that Bullet can handle.
namespace polhode::fuzz {

bool is_finite(const btVector3& v);
bool is_finite(const btMatrix3x3& m);
/// Checks pose, velocities and inverse world inertia.
bool is_finite(const btRigidBody& body);
/// Checks pose and velocities.
bool is_finite(const btMultiBody& multibody);

/// Returns a mass or moment whose inverse is finite, which any library needs. 0 is allowed where it means
/// that the body does not turn about the axis.
btScalar inertia(btScalar x, bool zero_is_allowed);
btVector3 moments(const btVector3& v);

btQuaternion orientation(const btVector3& v, btScalar x);

}  // namespace polhode::fuzz
