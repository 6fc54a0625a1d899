#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <optional>
#include <string>

#include "bullet/snapshot/rotation_record.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// The data of a btRigidBody in addition to those of a btCollisionObject.
struct RigidRecord {
  // Compared.
  btScalar inverse_mass = 0;
  btVector3 inverse_inertia_B = btVector3(0, 0, 0);
  // Restored.
  btVector3 linear_velocity = btVector3(0, 0, 0);
  btVector3 omega_W = btVector3(0, 0, 0);
  btMatrix3x3 inverse_inertia_W = btMatrix3x3::getIdentity();
  btVector3 force = btVector3(0, 0, 0);
  btVector3 torque_W = btVector3(0, 0, 0);
};

template <class Archive>
void serialize(Archive& archive, RigidRecord& record) {
  archive(record.inverse_mass, record.inverse_inertia_B, record.linear_velocity, record.omega_W,
          record.inverse_inertia_W, record.force, record.torque_W);
}

/// The data of a collision object: a rigid body, a static object or a ghost.
struct ObjectRecord {
  // Compared.
  std::int32_t type = 0;
  std::int32_t shape_type = 0;
  // Restored.
  btTransform pose = btTransform::getIdentity();
  btTransform interpolation_pose = btTransform::getIdentity();
  btVector3 interpolation_linear_velocity = btVector3(0, 0, 0);
  btVector3 interpolation_omega_W = btVector3(0, 0, 0);
  std::int32_t activation_state = 0;
  btScalar deactivation_time = 0;
  btScalar hit_fraction = 1;
  std::optional<RigidRecord> rigid;
  std::optional<RotationRecord> rotation;  ///< empty if no scheme rotates the object
};

template <class Archive>
void serialize(Archive& archive, ObjectRecord& record) {
  archive(record.type, record.shape_type, record.pose, record.interpolation_pose,
          record.interpolation_linear_velocity, record.interpolation_omega_W, record.activation_state,
          record.deactivation_time, record.hit_fraction, record.rigid, record.rotation);
}

/// Returns the record without `rotation`.
ObjectRecord record_of(btCollisionObject& object);

/// Checks that the object matches the record in type, shape, mass and inertia. `which` names the object in
/// the message.
/// @throws std::invalid_argument if it does not match.
void require_same_object(const ObjectRecord& record, const btCollisionObject& object,
                         const std::string& which);

/// Writes everything but `rotation`.
void write_to_object(const ObjectRecord& record, btCollisionObject& object) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
