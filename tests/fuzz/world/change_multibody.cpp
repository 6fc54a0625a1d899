#include "fuzz/world/change_multibody.h"

#include <cmath>

#include "fuzz/world/usable_numbers.h"

namespace polhode::fuzz {

namespace {

void move(const Operation& operation, btMultiBody& multibody) {
  const std::size_t variant = operation.variant;
  const btTransform pose(orientation(operation.b, operation.x), operation.a);
  if (variant % 8 == 0 || variant % 8 == 2) multibody.setBaseOmega(operation.a);
  if (variant % 8 == 1 || variant % 8 == 2) multibody.setBaseVel(operation.b);
  if (variant % 8 == 3 || variant % 8 == 4) multibody.setBaseWorldTransform(pose);
  if (variant % 8 == 4 && multibody.getBaseCollider() != nullptr)
    multibody.getBaseCollider()->setWorldTransform(pose);
  if (variant % 8 == 5) multibody.setBasePos(operation.a);
  if (variant % 8 == 6)
    multibody.setWorldToBaseRot(btQuaternion(operation.a.x(), operation.a.y(), operation.a.z(), operation.x));
  if (variant % 8 == 7) multibody.clearVelocities();
}

void push(const Operation& operation, btMultiBody& multibody) {
  const std::size_t variant = operation.variant;
  const int links = multibody.getNumLinks();
  if (variant % 8 == 0 || variant % 8 == 2) multibody.addBaseForce(operation.a);
  if (variant % 8 == 1 || variant % 8 == 2) multibody.addBaseTorque(operation.b);
  if (variant % 8 == 3 && links > 0) multibody.addLinkForce(links - 1, operation.a);
  if (variant % 8 == 4 && links > 0) multibody.addLinkTorque(0, operation.a);
  if (variant % 8 == 5) multibody.clearForcesAndTorques();
  if (variant % 8 == 6) multibody.clearConstraintForces();
  if (variant % 8 == 7) multibody.addBaseTorque(operation.a);
}

void set_activation(const Operation& operation, btMultiBody& multibody) {
  for (int link = -1; link < multibody.getNumLinks(); ++link) {
    btMultiBodyLinkCollider* const collider =
        link < 0 ? multibody.getBaseCollider() : multibody.getLinkCollider(link);
    if (collider != nullptr) collider->forceActivationState(1 + static_cast<int>(operation.slot % 5));
  }
}

void set(const Operation& operation, btMultiBody& multibody) {
  const bool is_on = operation.variant >= 32;
  const btScalar x = operation.x;
  switch (operation.variant % 16) {
    case 0:
      multibody.setLinearDamping(x);
      break;
    case 1:
      multibody.setAngularDamping(x);
      break;
    case 2:
    case 3:
      multibody.setUseGyroTerm(is_on);
      break;
    case 4:
    case 5:
      multibody.setCanSleep(is_on);
      break;
    case 6:
      multibody.setMaxCoordinateVelocity(std::abs(x));
      break;
    case 7:
      multibody.useGlobalVelocities(is_on);
      break;
    case 8:
      multibody.useRK4Integration(is_on);
      break;
    case 9:
      multibody.wakeUp();
      break;
    case 10:
      multibody.goToSleep();
      break;
    case 11:
      set_activation(operation, multibody);
      break;
    case 12:
      multibody.setBaseDynamicType(is_on ? btCollisionObject::CF_KINEMATIC_OBJECT
                                         : btCollisionObject::CF_DYNAMIC_OBJECT);
      break;
    case 13:
      multibody.setBaseMass(inertia(x, false));
      break;
    case 14:
      multibody.setBaseInertia(moments(operation.a));
      break;
    default:
      multibody.setSleepThreshold(x);
      multibody.setSleepTimeout(operation.y);
  }
}

}  // namespace

void change_multibody(const Operation& operation, MultibodySlot& slot) {
  btMultiBody& multibody = *slot.multibody();
  if (operation.kind == Kind::move_multibody) move(operation, multibody);
  if (operation.kind == Kind::push_multibody) push(operation, multibody);
  if (operation.kind == Kind::set_multibody) set(operation, multibody);
  slot.switches = slot.present_switches();
}

}  // namespace polhode::fuzz
