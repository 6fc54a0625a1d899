#include "bullet/non_finite.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <cmath>

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

bool is_finite(const btVector3& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool is_finite(const btMatrix3x3& basis) {
  return is_finite(basis[0]) && is_finite(basis[1]) && is_finite(basis[2]);
}

bool is_finite(const btTransform& pose) {
  return is_finite(pose.getOrigin()) && is_finite(pose.getBasis());
}

bool forces_are_finite(const btRigidBody& body) {
  return is_finite(body.getTotalForce()) && is_finite(body.getTotalTorque());
}

}  // namespace

bool is_finite(const btRigidBody& body) {
  return is_finite(body.getWorldTransform()) && is_finite(body.getLinearVelocity()) &&
         is_finite(body.getAngularVelocity()) && forces_are_finite(body);
}

Motion finite_motion(const btRigidBody& body, const Motion& fallback) {
  const auto choose = [](const auto& found, const auto& otherwise) {
    return is_finite(found) ? found : otherwise;
  };
  const btTransform& pose = body.getWorldTransform();
  return {btTransform(choose(pose.getBasis(), fallback.pose.getBasis()),
                      choose(pose.getOrigin(), fallback.pose.getOrigin())),
          choose(body.getLinearVelocity(), fallback.linear_velocity),
          choose(body.getAngularVelocity(), fallback.omega_W)};
}

void mend(btRigidBody& body, const Motion& fallback) {
  const Motion motion = finite_motion(body, fallback);
  if (!is_finite(body.getWorldTransform()) && body.getActivationState() == DISABLE_SIMULATION) {
    body.forceActivationState(ACTIVE_TAG);
  }
  if (!forces_are_finite(body)) body.clearForces();
  body.setLinearVelocity(motion.linear_velocity);
  body.setAngularVelocity(motion.omega_W);
  body.setCenterOfMassTransform(motion.pose);
}

void forget_contacts(btDispatcher& dispatcher, const btRigidBody& body) {
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    if (manifold->getBody0() == &body || manifold->getBody1() == &body) manifold->clearManifold();
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
