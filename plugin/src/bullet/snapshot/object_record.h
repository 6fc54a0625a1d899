#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <optional>
#include <string>

#include "bullet/snapshot/rotation_record.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// What a btRigidBody has beyond a btCollisionObject.
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

/// A collision object of any kind: rigid bodies, static ones and ghosts.
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
  std::optional<RotationRecord> rotation;  ///< none: Bullet rotates it, or nobody
};

template <class Archive>
void serialize(Archive& archive, ObjectRecord& record) {
  archive(record.type, record.shape_type, record.pose, record.interpolation_pose,
          record.interpolation_linear_velocity, record.interpolation_omega_W, record.activation_state,
          record.deactivation_time, record.hit_fraction, record.rigid, record.rotation);
}

/// Without `rotation`.
ObjectRecord record_of(btCollisionObject& object);

/// `which` names the object in the message.
/// @throws std::invalid_argument if the object is another than that of the record, by type, shape, mass or
/// inertia.
void require_same_object(const ObjectRecord& record, const btCollisionObject& object,
                         const std::string& which);

/// All but `rotation`.
void write_to_object(const ObjectRecord& record, btCollisionObject& object) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
