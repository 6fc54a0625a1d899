#include "bullet/world/world_stepper.h"

// The part of WorldStepper that tells which bodies the library rotates.
namespace polhode {
inline namespace POLHODE_PRECISION {

bool WorldStepper::is_in_world(const btRigidBody& body) const {
  if (world_ == nullptr || !claim_.holds()) return false;
  const int index = body.getWorldArrayIndex();
  const btCollisionObjectArray& objects = world_->getCollisionObjectArray();
  return index >= 0 && index < objects.size() && objects[index] == &body;
}

BodyRegistry::Lane WorldStepper::find(const btRigidBody& body) {
  if (body.isStaticOrKinematicObject() || !is_in_world(body)) return {nullptr, 0};
  const BodyRegistry::Lane known = rigid_.registry.find(body, choices_);
  if (known.batch != nullptr) return known;
  synchronize();
  return rigid_.registry.find(body, choices_);
}

BodyRegistry::Lane WorldStepper::find(const btMultiBody& multibody) {
  if (world_ == nullptr || !claim_.holds() || multibody.isBaseStaticOrKinematic()) return {nullptr, 0};
  if (!multibodies_.has(multibody)) synchronize();
  const int index = multibodies_.index_of(multibody);
  if (index < 0) return {nullptr, 0};
  MultibodyProxy& proxy = multibodies_[static_cast<std::size_t>(index)];
  proxy.read();
  return of_multibodies_.registry.find(proxy.body(), choices_);
}

BodyRegistry::Lane WorldStepper::lane_of(const btRigidBody& body) {
  if (!is_in_world(body)) return {nullptr, 0};
  return rigid_.registry.find(body, choices_);
}

bool WorldStepper::is_within_step() const {
  for (const Batch* batch : rigid_.registry.batches()) {
    if (batch->begun.any()) return true;
  }
  return false;
}

template <class Function>
void WorldStepper::for_each_managed(BodyGroup& group, const Function& function) {
  if (world_ == nullptr || !claim_.holds()) return;
  synchronize();
  for (std::size_t i = 0; i < group.registry.bodies().size(); ++i) {
    const btRigidBody& body = *group.registry.bodies()[i];
    if (group.registry.find(body, choices_).batch != nullptr && !group.is_static_or_kinematic(i)) function(i);
  }
}

std::size_t WorldStepper::managed_bodies() {
  std::size_t count = 0;
  for (BodyGroup* group : {&rigid_, &of_multibodies_})
    for_each_managed(*group, [&count](std::size_t) { ++count; });
  return count;
}

std::vector<btRigidBody*> WorldStepper::managed_rigid_bodies() {
  std::vector<btRigidBody*> managed;
  for_each_managed(rigid_, [&](std::size_t i) { managed.push_back(rigid_.registry.bodies()[i]); });
  return managed;
}

std::vector<btMultiBody*> WorldStepper::managed_multibodies() {
  std::vector<btMultiBody*> managed;
  for_each_managed(of_multibodies_, [&](std::size_t i) { managed.push_back(of_multibodies_.multibody(i)); });
  return managed;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
