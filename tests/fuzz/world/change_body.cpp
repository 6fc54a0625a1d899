#include "fuzz/world/change_body.h"

#include "fuzz/world/usable_numbers.h"

namespace polhode::fuzz {

void change_body(const Operation& operation, BodySlot& slot) {
  btRigidBody& body = *slot.body();
  const btVector3& a = operation.a;
  const std::size_t variant = operation.variant;
  switch (operation.kind) {
    case Kind::velocity:
      if (variant % 4 != 1) body.setAngularVelocity(a);
      if (variant % 4 != 0) body.setLinearVelocity(operation.b);
      if (variant % 4 == 3) body.setInterpolationAngularVelocity(a);
      break;
    case Kind::kick:
      if (variant % 8 == 0) body.applyTorqueImpulse(a);
      if (variant % 8 == 1) body.applyTorque(a);
      if (variant % 8 == 2) body.applyForce(a, operation.b);
      if (variant % 8 == 3) body.applyImpulse(a, operation.b);
      if (variant % 8 == 4) body.applyCentralForce(a);
      if (variant % 8 == 5) body.setGravity(a);
      if (variant % 8 == 6) body.applyTorqueTurnImpulse(a);
      if (variant % 8 == 6) body.applyPushImpulse(operation.b, a);
      if (variant % 8 == 7) body.clearForces();
      break;
    case Kind::damping:
      body.setDamping(operation.x, operation.y);
      break;
    case Kind::factors:
      if (variant % 2 == 0) body.setAngularFactor(a);
      if (variant % 4 == 1) body.setLinearFactor(a);
      if (variant % 4 == 3) {
        const auto bit = [variant](int shift) { return static_cast<btScalar>((variant >> shift) % 2); };
        body.setAngularFactor(btVector3(bit(2), bit(3), bit(4)));
      }
      break;
    case Kind::flags:
      slot.flags = static_cast<int>(variant % 16);
      body.setFlags(slot.flags);
      break;
    case Kind::mass: {
      // Mass 0 makes a body static, which must be known when the body is added to a world.
      if (body.isStaticObject()) break;
      body.setMassProps(inertia(operation.x, false), moments(a));
      if (variant % 2 == 0) body.updateInertiaTensor();
      break;
    }
    case Kind::teleport: {
      const btTransform pose(orientation(operation.b, operation.x), a);
      if (variant % 8 == 0) body.setCenterOfMassTransform(pose);
      if (variant % 8 == 1) body.setWorldTransform(pose);
      if (variant % 8 == 2) body.getWorldTransform().setRotation(pose.getRotation());
      if (variant % 8 == 3) body.translate(a);
      if (variant % 8 == 4) body.setInterpolationWorldTransform(pose);
      if (variant % 8 == 5) body.getWorldTransform().getBasis()[variant / 8 % 3] = a;
      if (variant % 8 == 6) body.proceedToTransform(pose);
      if (variant % 8 == 7) body.getWorldTransform().getBasis() = pose.getBasis().scaled(a);
      break;
    }
    case Kind::activation:
      if (variant % 8 < 5) body.forceActivationState(1 + static_cast<int>(variant % 8));
      if (variant % 8 == 5) body.activate(true);
      if (variant % 8 == 6) body.setDeactivationTime(operation.x);
      if (variant % 8 == 7) body.setSleepingThresholds(operation.x, operation.y);
      break;
    case Kind::kinematic:
      // Bullet's manual forbids this while the body is in a world.
      if (slot.world != BodySlot::kLimbo || body.isStaticObject()) break;
      body.setCollisionFlags(body.getCollisionFlags() ^ btCollisionObject::CF_KINEMATIC_OBJECT);
      break;
    case Kind::continuous_collision:
      body.setCcdMotionThreshold(variant % 2 == 0 ? btScalar(0.1) : btScalar(0));
      body.setCcdSweptSphereRadius(btScalar(0.2));
      break;
    case Kind::material:
      if (variant % 4 == 0) body.setFriction(operation.x);
      if (variant % 4 == 1) body.setRestitution(operation.x);
      if (variant % 4 == 2) body.setRollingFriction(operation.x);
      if (variant % 4 == 3)
        body.setCollisionFlags(body.getCollisionFlags() ^ btCollisionObject::CF_NO_CONTACT_RESPONSE);
      break;
    default:
      break;
  }
}

}  // namespace polhode::fuzz
