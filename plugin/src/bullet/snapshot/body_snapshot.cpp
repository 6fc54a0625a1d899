#include "bullet/snapshot/body_snapshot.h"

#include <stdexcept>

#include "bullet/snapshot/envelope.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

void require_between_steps(WorldStepper& stepper) {
  if (!stepper.is_attached()) {
    throw std::logic_error(
        "the plugin is detached, or its world is gone: call attach() before saving or restoring");
  }
  stepper.synchronize();
  if (stepper.is_within_step()) {
    throw std::logic_error(
        "this function cannot be called within a step: call it between two calls of stepSimulation, or in "
        "the tick callback at the end of a substep");
  }
}

ObjectRecord record_of(WorldStepper& stepper, btCollisionObject& object) {
  ObjectRecord record = record_of(object);
  if (btRigidBody* const body = btRigidBody::upcast(&object)) {
    const BodyRegistry::Lane place = stepper.lane_of(*body);
    if (place.batch != nullptr) record.rotation = record_of(*place.batch, place.lane);
  }
  return record;
}

SchemePointer require_restorable(WorldStepper& stepper, const ObjectRecord& record, btCollisionObject& object,
                                 const std::string& which) {
  require_same_object(record, object, which);
  if (!record.rotation.has_value()) return nullptr;
  const BodyRegistry::Lane place = stepper.lane_of(*btRigidBody::upcast(&object));
  return require_scheme_of(*record.rotation, place.batch != nullptr ? place.batch->scheme : nullptr);
}

void write_to_object(WorldStepper& stepper, ObjectRecord& record, const SchemePointer& scheme,
                     btCollisionObject& object) {
  btRigidBody* const body = btRigidBody::upcast(&object);
  if (body != nullptr) {
    const Batch* const batch = stepper.lane_of(*body).batch;
    const SchemePointer present = batch != nullptr ? batch->scheme : nullptr;
    if (scheme != present) stepper.choose(*body, scheme);
    const bool has_rotors = record.rotation && record.rotation->drive && record.rotation->drive->has_rotors();
    if (has_rotors) stepper.make_drive(*body);
  }
  write_to_object(record, object);
  if (body == nullptr || !record.rotation.has_value()) return;
  const BodyRegistry::Lane place = stepper.lane_of(*body);
  if (place.batch != nullptr) write_to_lane(*record.rotation, *place.batch, place.lane);
  stepper.drop_idle_drive(*body);
}

Snapshot save_body(WorldStepper& stepper, btRigidBody& body) {
  require_between_steps(stepper);
  ObjectRecord record = record_of(stepper, body);
  return to_snapshot(SnapshotKind::body, record);
}

void restore_body(WorldStepper& stepper, btRigidBody& body, const Snapshot& snapshot) {
  require_between_steps(stepper);
  auto record = from_snapshot<ObjectRecord>(SnapshotKind::body, snapshot);
  const SchemePointer scheme = require_restorable(stepper, record, body, "this body");
  write_to_object(stepper, record, scheme, body);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
