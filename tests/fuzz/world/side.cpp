#include "fuzz/world/side.h"

#include <cmath>

#include "fuzz/fail.h"
#include "fuzz/world/usable_numbers.h"

namespace polhode::fuzz {

namespace {

constexpr btScalar kDt = btScalar(1.0 / 60);
Side* side_in_step = nullptr;  // Bullet's contact callback has no argument that could carry this pointer

void before_tick(btDynamicsWorld* world, btScalar /*dt*/) {
  static_cast<Side*>(world->getWorldUserInfo())->in_step(Place::before);
}

void after_tick(btDynamicsWorld* world, btScalar /*dt*/) {
  static_cast<Side*>(world->getWorldUserInfo())->in_step(Place::after);
}

bool contact_processed(btManifoldPoint& /*point*/, void* a, void* b) {
  const auto body = [](void* object) { return btRigidBody::upcast(static_cast<btCollisionObject*>(object)); };
  if (side_in_step != nullptr) side_in_step->in_step(Place::contact, body(a), body(b));
  return true;
}

}  // namespace

Side::Side(Way way, const Limits& limits) : way_(way), limits_(limits) {
  shapes_.push_back(std::make_unique<btBoxShape>(btVector3(btScalar(0.3), btScalar(0.4), btScalar(0.5))));
  shapes_.push_back(std::make_unique<btSphereShape>(btScalar(0.5)));
  shapes_.push_back(std::make_unique<btCapsuleShape>(btScalar(0.3), 1));
  shapes_.push_back(std::make_unique<btCylinderShape>(btVector3(btScalar(0.3), 1, btScalar(0.3))));
  shapes_.push_back(std::make_unique<btBoxShape>(btVector3(20, 20, 1)));
  make_world(0);
}

Side::~Side() {
  for (Joint& joint : joints_) unjoin(joint);
  for (MultibodySlot& slot : multibodies_) remove(slot);
  for (BodySlot& slot : slots_) remove(slot);
}

void Side::make_world(std::size_t index) {
  worlds_[index] = std::make_unique<World>(way_, limits_.world_kind, [this] { in_step(Place::action); });
  World& made = *worlds_[index];
  made.world->setInternalTickCallback(before_tick, this, true);
  made.world->setInternalTickCallback(after_tick, this, false);
  choices_[index].fill(Choice::unset);
  multibody_choices_[index].fill(Choice::unset);
  has_default_[index] = true;
  if (made.rotation == nullptr) return;
  if (!limits_.managed) {
    made.rotation->clear_default_scheme();
    has_default_[index] = false;
  }
  made.rotation->set_incident_handler([this, &made, index](const Incident& incident) {
    ++made.reports;
    if (incident.kind == IncidentKind::non_finite_body) has_left_contract_ = true;
    for (const MultibodySlot& slot : multibodies_) {
      if (incident.multibody != nullptr && incident.body == nullptr &&
          slot.multibody() == incident.multibody && slot.world == static_cast<int>(index))
        return;
    }
    for (const BodySlot& slot : slots_) {
      if (incident.body != nullptr && incident.multibody == nullptr && slot.body() == incident.body &&
          slot.world == static_cast<int>(index))
        return;
    }
    fail("an incident names a body that is not in the world");
  });
}

const RotationControl* Side::rotation(std::size_t world) const {
  return worlds_[world] == nullptr ? nullptr : worlds_[world]->rotation;
}

std::vector<std::pair<int, int>> Side::pairs(std::size_t world) const {
  return worlds_[world] == nullptr ? std::vector<std::pair<int, int>>() : worlds_[world]->pairs();
}

void Side::forget_choices_of_absent(std::size_t world) {
  if (!worlds_[world]->is_rotated()) return;
  for (std::size_t i = 0; i < kSlots; ++i) {
    if (slots_[i].world != static_cast<int>(world)) choices_[world][i] = Choice::unset;
  }
  forget_choices_of_absent_multibodies(world);
}

void Side::in_step(Place place, btRigidBody* a, btRigidBody* b) {
  if (!is_in_step_) return;
  if (place == Place::after) {
    has_taken_step_ = true;
    for (BodySlot& slot : slots_) slot.is_finite_at_tick = slot.body() != nullptr && is_finite(*slot.body());
    for (MultibodySlot& slot : multibodies_)
      slot.is_finite_at_tick = slot.multibody() != nullptr && is_finite(*slot.multibody());
  }
  if (place == Place::action) check_left_as_they_were(true);
  // By index: a motion state may call this function again.
  for (std::size_t i = 0; i < script_.size(); ++i) {
    if (script_[i].place != place || script_[i].kind == Kind::step) continue;
    Operation operation = script_[i];
    if (place == Place::contact) {
      const btRigidBody* body = operation.slot % 2 == 0 ? a : b;
      if (body == nullptr || body->isStaticOrKinematicObject()) continue;
      operation.slot = static_cast<std::size_t>(body->getUserIndex());
    }
    script_[i].kind = Kind::step;  // at most once per step
    if (place == Place::motion_state) has_acted_in_motion_state_ = true;
    apply(operation);
    if (is_of_multibody(operation.kind)) {
      MultibodySlot& slot = multibodies_[operation.slot % kMultibodies];
      if (slot.multibody() != nullptr && place != Place::before && !is_finite(*slot.multibody()))
        slot.left_non_finite = true;
      continue;
    }
    BodySlot& slot = slots_[operation.slot];
    if (slot.body() != nullptr && place != Place::before && place != Place::contact &&
        !is_finite(*slot.body()))
      slot.left_non_finite = true;
  }
  if (place != Place::before) return;
  forget_choices_of_absent(stepped_);
  begin_step_of_multibodies();
}

void Side::step(const Operation& operation, const std::vector<Operation>& script) {
  if (worlds_[operation.world] == nullptr) make_world(operation.world);
  for (BodySlot& slot : slots_) {
    slot.left_non_finite = false;
    if (slot.motion_state != nullptr) slot.motion_state->is_shown = false;
  }
  for (MultibodySlot& slot : multibodies_) slot.left_non_finite = false;
  has_acted_in_motion_state_ = false;
  script_ = script;
  stepped_ = operation.world;
  is_in_step_ = true;
  has_taken_step_ = false;
  side_in_step = this;
  gContactProcessedCallback = limits_.contact_callbacks ? contact_processed : nullptr;
  btDiscreteDynamicsWorld& world = *worlds_[operation.world]->world;
  const std::size_t variant = operation.variant;
  if (variant < 32) {
    world.stepSimulation(kDt, 0, kDt);
  } else if (variant < 40) {
    world.stepSimulation(kDt / 4, 0, kDt / 4);
  } else if (variant < 48) {
    world.stepSimulation(kDt * static_cast<btScalar>(variant - 40) / 2, 4, kDt);
  } else if (variant < 56) {
    world.stepSimulation(operation.x, 0, operation.x);
  } else {
    const bool is_step = std::isfinite(operation.y) && operation.y > btScalar(1e-6);
    world.stepSimulation(operation.x, static_cast<int>(variant % 4), is_step ? operation.y : kDt);
  }
  gContactProcessedCallback = nullptr;
  side_in_step = nullptr;
  is_in_step_ = false;
}

}  // namespace polhode::fuzz
