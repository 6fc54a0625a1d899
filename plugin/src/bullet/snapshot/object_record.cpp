#include "bullet/snapshot/object_record.h"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <sstream>

#include "bullet/snapshot/archive.h"
#include "polhode/bullet/conversions.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

RigidRecord record_of_rigid(btRigidBody& body) {
  RigidRecord record;
  record.inverse_mass = body.getInvMass();
  record.inverse_inertia_B = body.getInvInertiaDiagLocal();
  record.linear_velocity = body.getLinearVelocity();
  record.omega_W = body.getAngularVelocity();
  record.inverse_inertia_W = body.getInvInertiaTensorWorld();
  record.force = body.getTotalForce();
  record.torque_W = body.getTotalTorque();
  return record;
}

void write_to_rigid(const RigidRecord& record, btRigidBody& body) {
  // Bullet's setters would also increment revision numbers.
  linear_velocity(body) = record.linear_velocity;
  angular_velocity(body) = record.omega_W;
  inverse_inertia_tensor_W(body) = record.inverse_inertia_W;
  total_force(body) = record.force;
  total_torque(body) = record.torque_W;
}

int shape_type_of(const btCollisionObject& object) {
  const btCollisionShape* const shape = object.getCollisionShape();
  return shape == nullptr ? INVALID_SHAPE_PROXYTYPE : shape->getShapeType();
}

std::string text_of(const RigidRecord& record) {
  const btVector3& inverse_B = record.inverse_inertia_B;
  std::ostringstream text;
  text << "inverse mass " << record.inverse_mass << ", inverse moments " << inverse_B.x() << ", "
       << inverse_B.y() << ", " << inverse_B.z();
  return text.str();
}

}  // namespace

ObjectRecord record_of(btCollisionObject& object) {
  ObjectRecord record;
  record.type = object.getInternalType();
  record.shape_type = shape_type_of(object);
  record.pose = object.getWorldTransform();
  record.interpolation_pose = object.getInterpolationWorldTransform();
  record.interpolation_linear_velocity = object.getInterpolationLinearVelocity();
  record.interpolation_omega_W = object.getInterpolationAngularVelocity();
  record.activation_state = object.getActivationState();
  record.deactivation_time = object.getDeactivationTime();
  record.hit_fraction = object.getHitFraction();
  if (btRigidBody* const body = btRigidBody::upcast(&object)) record.rigid = record_of_rigid(*body);
  return record;
}

void require_same_object(const ObjectRecord& record, const btCollisionObject& object,
                         const std::string& which) {
  if (record.type != object.getInternalType() || record.shape_type != shape_type_of(object))
    refuse_snapshot(which + " has another type or another type of shape than in the snapshot");
  if (record.activation_state < ACTIVE_TAG || record.activation_state > FIXED_BASE_MULTI_BODY)
    refuse_snapshot("the activation state of " + which + " is not a valid Bullet state");
  const btRigidBody* const body = btRigidBody::upcast(&object);
  if ((body != nullptr) != record.rigid.has_value())
    refuse_snapshot(which + " is a rigid body either only in the snapshot or only in the world");
  if (record.rotation.has_value() && body == nullptr)
    refuse_snapshot(which + " is rotated by a scheme in the snapshot, but is not a rigid body");
  if (body == nullptr) return;
  const RigidRecord& rigid = *record.rigid;
  if (rigid.inverse_mass == body->getInvMass() &&
      same(rigid.inverse_inertia_B, body->getInvInertiaDiagLocal()))
    return;
  RigidRecord present;
  present.inverse_mass = body->getInvMass();
  present.inverse_inertia_B = body->getInvInertiaDiagLocal();
  refuse_snapshot(which + " has " + text_of(present) + "; the snapshot has " + text_of(rigid) +
                  ": set mass and inertia to the snapshot's values first");
}

void write_to_object(const ObjectRecord& record, btCollisionObject& object) noexcept {
  object.setWorldTransform(record.pose);
  object.setInterpolationWorldTransform(record.interpolation_pose);
  object.setInterpolationLinearVelocity(record.interpolation_linear_velocity);
  object.setInterpolationAngularVelocity(record.interpolation_omega_W);
  object.forceActivationState(record.activation_state);
  object.setDeactivationTime(record.deactivation_time);
  object.setHitFraction(record.hit_fraction);
  if (btRigidBody* const body = btRigidBody::upcast(&object)) write_to_rigid(*record.rigid, *body);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
