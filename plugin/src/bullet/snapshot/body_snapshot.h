#pragma once

#include "bullet/snapshot/object_record.h"
#include "bullet/world/world_stepper.h"
#include "polhode/bullet/snapshot.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Checks that a snapshot may be saved or restored now. Also synchronizes the stepper, as the other functions
/// require.
/// @throws std::logic_error within a step, or if the stepper is detached from its world.
void require_between_steps(WorldStepper& stepper);

/// Returns the record of an object of the world, with `rotation`.
ObjectRecord record_of(WorldStepper& stepper, btCollisionObject& object);

/// Returns the scheme for the object; null if Bullet is to rotate it. Changes nothing.
/// @throws std::invalid_argument as require_same_object and require_scheme_of.
SchemePointer require_restorable(WorldStepper& stepper, const ObjectRecord& record, btCollisionObject& object,
                                 const std::string& which);
/// Writes a restorable record to the object.
/// @throws std::bad_alloc if the scheme must be changed and memory runs out; nothing has changed then.
void write_to_object(WorldStepper& stepper, ObjectRecord& record, const SchemePointer& scheme,
                     btCollisionObject& object);

/// Implement RotationControl::save and restore.
Snapshot save_body(WorldStepper& stepper, btRigidBody& body);
void restore_body(WorldStepper& stepper, btRigidBody& body, const Snapshot& snapshot);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
