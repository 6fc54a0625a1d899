#include "bullet/body/non_finite.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

namespace polhode {
inline namespace POLHODE_PRECISION {

BodyMotion finite_motion(const btRigidBody& body, const BodyMotion& fallback) {
  const auto choose = [](const auto& found, const auto& otherwise) {
    return are_finite(found) ? found : otherwise;
  };
  const btTransform& pose = body.getWorldTransform();
  return {btTransform(choose(pose.getBasis(), fallback.pose.getBasis()),
                      choose(pose.getOrigin(), fallback.pose.getOrigin())),
          choose(body.getLinearVelocity(), fallback.linear_velocity),
          choose(body.getAngularVelocity(), fallback.omega_W)};
}

void sanitize(btRigidBody& body, const BodyMotion& fallback) {
  const BodyMotion motion = finite_motion(body, fallback);
  if (!is_finite(body) && body.getActivationState() == DISABLE_SIMULATION) {
    body.forceActivationState(ACTIVE_TAG);
  }
  if (!are_finite(body.getTotalForce(), body.getTotalTorque())) body.clearForces();
  body.setLinearVelocity(motion.linear_velocity);
  body.setAngularVelocity(motion.omega_W);
  body.setCenterOfMassTransform(motion.pose);
}

void forget_contacts(btDispatcher& dispatcher, const btCollisionObject& object) {
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    if (manifold->getBody0() == &object || manifold->getBody1() == &object) manifold->clearManifold();
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
