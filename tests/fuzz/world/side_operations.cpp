#include <cmath>
#include <stdexcept>

#include "fuzz/fail.h"
#include "fuzz/world/change_body.h"
#include "fuzz/world/joints.h"
#include "fuzz/world/side.h"
#include "fuzz/world/usable_numbers.h"

namespace polhode::fuzz {

namespace {

const SchemePointer& scheme(std::size_t variant) {
  return built_in_schemes()[variant % built_in_schemes().size()];
}

}  // namespace

void Side::apply(const Operation& operation) {
  const std::size_t index = operation.world;
  if (worlds_[index] == nullptr) make_world(index);
  if (is_of_multibody(operation.kind)) return apply_to_multibody(operation);
  World& world = *worlds_[index];
  BodySlot& slot = slots_[operation.slot];
  switch (operation.kind) {
    case Kind::add:
      if (slot.body() == nullptr) add(operation, slot);
      return;
    case Kind::remove:
      remove(slot);
      return;
    case Kind::put_back:
      if (slot.body() != nullptr && slot.world == BodySlot::kLimbo) put(slot, index);
      return;
    case Kind::erase:
      remove(slot);
      // A soft body keeps its contacts until the end of the step.
      if (is_in_step_ && has_soft_bodies(limits_.world_kind)) return;
      slot.destroy();
      for (auto& choices : choices_) choices[operation.slot] = Choice::unset;
      return;
    case Kind::choose_scheme:
    case Kind::release:
    case Kind::use_default_scheme:
      if (slot.body() != nullptr) choose(operation, index);
      return;
    case Kind::default_scheme:
      choose_default_scheme(operation, index);
      return;
    case Kind::drive:
      if (slot.body() != nullptr && world.rotation != nullptr) drive(operation);
      return;
    case Kind::clear_default_scheme:
      if (world.rotation != nullptr) world.rotation->clear_default_scheme();
      has_default_[index] = false;
      return;
    case Kind::detach:
      if (world.plugin != nullptr) world.plugin->detach();
      return;
    case Kind::attach:
      if (world.plugin != nullptr) world.plugin->attach();
      return;
    case Kind::renew_second_world:
      renew_second_world(operation);
      return;
    case Kind::join:
      join(operation);
      return;
    case Kind::unjoin:
      unjoin(joints_[operation.slot % kJoints]);
      return;
    case Kind::motor: {
      const Joint& joint = joints_[operation.slot % kJoints];
      if (joint.constraint == nullptr) return;
      joint.constraint->setEnabled(operation.variant % 4 != 0);
      if (joint.constraint->getConstraintType() == HINGE_CONSTRAINT_TYPE)
        static_cast<btHingeConstraint&>(*joint.constraint)
            .enableAngularMotor(operation.variant % 2 == 0, operation.x, std::abs(operation.y));
      return;
    }
    case Kind::gravity:
      world.world->setGravity(operation.a);
      return;
    case Kind::settings:
      world.set(operation);
      return;
    default:
      if (slot.body() != nullptr) change_body(operation, slot);
  }
}

void Side::add(const Operation& operation, BodySlot& slot) {
  const std::size_t variant = operation.variant;
  btCollisionShape& shape = *shapes_[variant % shapes_.size()];
  const bool is_static = variant % 8 == 4;
  const btScalar mass = is_static ? btScalar(0) : inertia(operation.y, false);
  btVector3 inertia_B = moments(operation.b);
  if (variant % 4 != 0) shape.calculateLocalInertia(mass, inertia_B);
  if (is_static) inertia_B.setZero();
  const btTransform pose(orientation(btVector3(operation.x, 1, operation.x), 2), operation.a);
  if (variant % 4 != 3)
    slot.motion_state = std::make_unique<ShownPose>(pose, [this] { in_step(Place::motion_state); });
  btRigidBody::btRigidBodyConstructionInfo info(mass, slot.motion_state.get(), &shape, inertia_B);
  info.m_startWorldTransform = pose;
  slot.make(info, variant % 2 == 0);
  slot.body()->setUserIndex(static_cast<int>(operation.slot));
  put(slot, operation.world);
}

void Side::put(BodySlot& slot, std::size_t world) {
  worlds_[world]->world->addRigidBody(slot.body());
  slot.world = static_cast<int>(world);
}

// Remove joints first: Bullet's islands would index their arrays with the stale tag of a removed body.
void Side::remove(BodySlot& slot) {
  if (slot.body() == nullptr || slot.world == BodySlot::kLimbo) return;
  for (Joint& joint : joints_) {
    if (joint.a == slot.body() || joint.b == slot.body()) unjoin(joint);
  }
  unpin_from(*slot.body());
  worlds_[static_cast<std::size_t>(slot.world)]->world->removeRigidBody(slot.body());
  slot.world = BodySlot::kLimbo;
}

void Side::join(const Operation& operation) {
  Joint& joint = joints_[operation.slot % kJoints];
  unjoin(joint);
  const BodySlot& first = slots_[operation.slot];
  if (first.body() == nullptr || first.world == BodySlot::kLimbo) return;
  btRigidBody* partner = nullptr;
  if (operation.other != kSlots) {
    const BodySlot& second = slots_[operation.other];
    if (second.body() == nullptr || second.world != first.world || &first == &second) return;
    partner = second.body();
  }
  joint.constraint = make_joint(operation, *first.body(), partner);
  if (joint.constraint == nullptr) return;
  joint.world = static_cast<std::size_t>(first.world);
  joint.a = first.body();
  joint.b = partner;
  worlds_[joint.world]->world->addConstraint(joint.constraint.get(), operation.variant % 8 < 4);
}

void Side::unjoin(Joint& joint) {
  if (joint.constraint == nullptr) return;
  worlds_[joint.world]->world->removeConstraint(joint.constraint.get());
  joint = Joint();
}

void Side::choose(const Operation& operation, std::size_t index) {
  World& world = *worlds_[index];
  btRigidBody& body = *slots_[operation.slot].body();
  Choice& choice = choices_[index][operation.slot];
  if (operation.kind == Kind::choose_scheme) {
    try {
      if (world.rotation != nullptr) world.rotation->set_scheme(body, scheme(operation.variant));
    } catch (const std::invalid_argument&) {
      if (!body.isStaticObject() && !may_have_rotors_) throw;
      return;
    }
    choice = Choice::scheme;
  } else if (operation.kind == Kind::release) {
    if (world.rotation != nullptr) world.rotation->release(body);
    choice = Choice::released;
  } else {
    if (world.rotation != nullptr) world.rotation->use_default_scheme(body);
    choice = Choice::unset;
  }
}

void Side::choose_default_scheme(const Operation& operation, std::size_t index) {
  try {
    RotationControl* const rotation = worlds_[index]->rotation;
    if (rotation != nullptr) rotation->set_default_scheme(scheme(operation.variant));
    has_default_[index] = true;
  } catch (const std::invalid_argument&) {
    if (!may_have_rotors_) throw;
  }
}

void Side::renew_second_world(const Operation& operation) {
  if (is_in_step_ || worlds_[1] == nullptr) return;
  World& world = *worlds_[1];
  for (Joint& joint : joints_) {
    if (joint.world == 1) unjoin(joint);
  }
  const bool with_bodies = operation.variant % 2 == 0;
  for (BodySlot& slot : slots_) {
    if (slot.world != 1) continue;
    if (!with_bodies) remove(slot);
    slot.world = BodySlot::kLimbo;
  }
  for (MultibodySlot& slot : multibodies_) leave_second_world(slot, with_bodies);
  world.world->removeAction(&world.action);
  if (world.plugin != nullptr && operation.variant % 4 < 2) {
    orphan_ = std::move(world.plugin);
    const bool is_told = orphan_->attached();
    world.world.reset();
    const btRigidBody* const any = slots_[operation.slot].body();
    if (orphan_->attached() || orphan_->rotation().managed_bodies() != 0 ||
        (any != nullptr && orphan_->rotation().manages(*any)))
      fail("a plugin manages bodies of a world that is gone");
    orphan_->detach();
    bool has_thrown = false;
    try {
      if (is_told) orphan_->attach();
    } catch (const std::logic_error&) {
      has_thrown = true;
    }
    if (has_thrown != is_told) fail("a plugin attached to a world that is gone");
  }
  worlds_[1].reset();
  choices_[1].fill(Choice::unset);
  multibody_choices_[1].fill(Choice::unset);
}

}  // namespace polhode::fuzz
