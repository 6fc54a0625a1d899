#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Whether pose, velocities, force and torque of the body are all finite.
bool is_finite(const btRigidBody& body);

/// The motion of a body as Bullet holds it.
struct Motion {
  btTransform pose = btTransform::getIdentity();
  btVector3 linear_velocity = btVector3(0, 0, 0);
  btVector3 omega_W = btVector3(0, 0, 0);
};

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
