#pragma once

#include "bullet/snapshot/object_record.h"
#include "bullet/world/world_stepper.h"
#include "polhode/bullet/snapshot.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Synchronizes the stepper, as the other functions want it.
/// @throws std::logic_error within a step, or if the stepper is detached from its world.
void require_between_steps(WorldStepper& stepper);

/// The record of an object of the world, with `rotation`.
ObjectRecord record_of(WorldStepper& stepper, btCollisionObject& object);

/// The scheme that the object is to have; null: Bullet is to rotate it. Changes nothing.
/// @throws std::invalid_argument as require_same_object and require_scheme_of.
SchemePointer require_restorable(WorldStepper& stepper, const ObjectRecord& record, btCollisionObject& object,
                                 const std::string& which);
/// Writes the record, which is restorable.
/// @throws std::bad_alloc, having changed nothing, where the body is to have another scheme than at present.
void write_to_object(WorldStepper& stepper, ObjectRecord& record, const SchemePointer& scheme,
                     btCollisionObject& object);

/// RotationControl::save and restore.
Snapshot save_body(WorldStepper& stepper, btRigidBody& body);
void restore_body(WorldStepper& stepper, btRigidBody& body, const Snapshot& snapshot);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
