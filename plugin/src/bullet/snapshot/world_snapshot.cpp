#include "bullet/snapshot/world_snapshot.h"

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "bullet/internals/private_members.h"
#include "bullet/snapshot/body_snapshot.h"
#include "bullet/snapshot/envelope.h"
#include "bullet/snapshot/world_record.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

btDbvtBroadphase* broadphase_of(btDiscreteDynamicsWorld& world) {
  return dynamic_cast<btDbvtBroadphase*>(world.getBroadphase());
}

void require_snapshot_of(btDiscreteDynamicsWorld& world) {
  const auto* const multibody_world = dynamic_cast<const btMultiBodyDynamicsWorld*>(&world);
  bool are_rigid = multibody_world == nullptr || multibody_world->getNumMultibodies() == 0;
  const btCollisionObjectArray& objects = world.getCollisionObjectArray();
  constexpr int kSaved = btCollisionObject::CO_RIGID_BODY | btCollisionObject::CO_COLLISION_OBJECT |
                         btCollisionObject::CO_GHOST_OBJECT;
  for (int i = 0; i < objects.size(); ++i) are_rigid &= (objects[i]->getInternalType() & ~kSaved) == 0;
  if (!are_rigid) {
    throw std::invalid_argument(
        "a world with multibodies, soft bodies or custom collision objects cannot be saved or restored: "
        "valid are rigid bodies, static objects and ghost objects");
  }
  if (broadphase_of(world) == nullptr ||
      dynamic_cast<btHashedOverlappingPairCache*>(world.getPairCache()) == nullptr ||
      dynamic_cast<btCollisionDispatcher*>(world.getDispatcher()) == nullptr) {
    throw std::invalid_argument(
        "a world with a custom broadphase, pair cache or dispatcher cannot be saved or restored: valid are "
        "btDbvtBroadphase, btHashedOverlappingPairCache and btCollisionDispatcher");
  }
}

WorldRecord record_of_world(WorldStepper& stepper) {
  btDiscreteDynamicsWorld& world = stepper.world();
  const btCollisionObjectArray& objects = world.getCollisionObjectArray();
  WorldRecord record;
  for (int i = 0; i < objects.size(); ++i) record.objects.push_back(record_of(stepper, *objects[i]));
  for (int i = 0; i < world.getNonStaticRigidBodies().size(); ++i)
    record.non_static.push_back(world.getNonStaticRigidBodies()[i]->getWorldArrayIndex());
  for (int i = 0; i < world.getNumConstraints(); ++i)
    record.joints.push_back(record_of(*world.getConstraint(i)));
  record.broadphase = record_of(*broadphase_of(world), objects);
  record.contacts = record_of_contacts(world);
  record.clock = clock_of(world);
  record.clock.law_time_s = stepper.time_s;
  return record;
}

template <class Element>
bool have_same_elements(std::vector<Element> a, const btAlignedObjectArray<Element>& present) {
  std::vector<Element> b;
  for (int i = 0; i < present.size(); ++i) b.push_back(present[i]);
  std::sort(a.begin(), a.end(), std::less<>());
  std::sort(b.begin(), b.end(), std::less<>());
  return a == b;
}

void require_order(const WorldOrder& order, btDiscreteDynamicsWorld& world) {
  if (!have_same_elements(order.objects, world.getCollisionObjectArray()) ||
      !have_same_elements(order.joints, joints(world))) {
    throw std::invalid_argument(
        "the order does not list each collision object and each joint of the world exactly once: add or "
        "remove bodies and joints first, so that the world has those of the snapshot");
  }
}

void require_same_count(std::size_t saved, std::size_t present, const char* what) {
  if (saved == present) return;
  refuse_snapshot("it is of a world with " + std::to_string(saved) + " " + what + "; this one has " +
                  std::to_string(present));
}

std::vector<btRigidBody*> non_static_of(const WorldRecord& record, const WorldOrder& order) {
  std::vector<btRigidBody*> bodies;
  for (const std::int32_t object : record.non_static) {
    const bool is_object = object >= 0 && static_cast<std::size_t>(object) < order.objects.size();
    bodies.push_back(is_object ? btRigidBody::upcast(order.objects[static_cast<std::size_t>(object)])
                               : nullptr);
  }
  return bodies;
}

// Throws if anything is wrong with the snapshot. Returns the scheme of each object.
std::vector<SchemePointer> require_restorable(WorldStepper& stepper, const WorldRecord& record,
                                              const WorldOrder& order) {
  require_same_count(record.objects.size(), order.objects.size(), "bodies and other collision objects");
  require_same_count(record.joints.size(), order.joints.size(), "joints");
  std::vector<SchemePointer> schemes;
  for (std::size_t i = 0; i < order.objects.size(); ++i) {
    schemes.push_back(
        require_restorable(stepper, record.objects[i], *order.objects[i], "object " + std::to_string(i)));
  }
  for (std::size_t i = 0; i < order.joints.size(); ++i) {
    if (record.joints[i].type != order.joints[i]->getConstraintType())
      refuse_snapshot("joint " + std::to_string(i) + " has another type than in the snapshot");
  }
  if (!have_same_elements(non_static_of(record, order), stepper.world().getNonStaticRigidBodies()))
    refuse_snapshot("the static bodies are not those of the snapshot");
  const std::size_t pairs = record.contacts.pairs.size();
  if (!is_consistent(record.broadphase, record.objects.size()) ||
      !is_consistent(record.contacts, record.objects.size()) ||
      static_cast<std::size_t>(record.broadphase.cleanup_index) > pairs)
    refuse_snapshot("its contacts or its broadphase are inconsistent");
  return schemes;
}

void restore_order(const WorldRecord& record, const WorldOrder& order, btDiscreteDynamicsWorld& world) {
  btCollisionObjectArray& objects = world.getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    objects[i] = order.objects[static_cast<std::size_t>(i)];
    objects[i]->setWorldArrayIndex(i);
  }
  const std::vector<btRigidBody*> non_static = non_static_of(record, order);
  for (std::size_t i = 0; i < non_static.size(); ++i)
    world.getNonStaticRigidBodies()[static_cast<int>(i)] = non_static[i];
  for (std::size_t i = 0; i < order.joints.size(); ++i) joints(world)[static_cast<int>(i)] = order.joints[i];
}

}  // namespace

WorldOrder order_of(btDynamicsWorld& world) {
  WorldOrder order;
  for (int i = 0; i < world.getNumCollisionObjects(); ++i)
    order.objects.push_back(world.getCollisionObjectArray()[i]);
  for (int i = 0; i < world.getNumConstraints(); ++i) order.joints.push_back(world.getConstraint(i));
  return order;
}

Snapshot save_world(WorldStepper& stepper) {
  require_between_steps(stepper);
  require_snapshot_of(stepper.world());
  WorldRecord record = record_of_world(stepper);
  return to_snapshot(SnapshotKind::world, record);
}

void restore_world(WorldStepper& stepper, const Snapshot& snapshot, const WorldOrder& order) {
  require_between_steps(stepper);
  btDiscreteDynamicsWorld& world = stepper.world();
  require_snapshot_of(world);
  require_order(order, world);
  auto record = from_snapshot<WorldRecord>(SnapshotKind::world, snapshot);
  const std::vector<SchemePointer> schemes = require_restorable(stepper, record, order);

  restore_order(record, order, world);
  stepper.synchronize();
  for (std::size_t i = 0; i < order.objects.size(); ++i)
    write_to_object(stepper, record.objects[i], schemes[i], *order.objects[i]);
  ContactRestoration contacts(world);
  write_to(record.broadphase, world.getCollisionObjectArray(), *broadphase_of(world));
  contacts.finish(record.contacts);
  for (std::size_t i = 0; i < order.joints.size(); ++i) write_to(record.joints[i], *order.joints[i]);
  write_to(record.clock, world);
  stepper.time_s = record.clock.law_time_s;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
