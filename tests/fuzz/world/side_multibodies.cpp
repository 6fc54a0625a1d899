// Operations and checks of a side on multibodies.
#include <cmath>
#include <stdexcept>

#include "fuzz/fail.h"
#include "fuzz/world/change_multibody.h"
#include "fuzz/world/side.h"
#include "fuzz/world/usable_numbers.h"

namespace polhode::fuzz {

namespace {

std::string name_of(std::size_t index) {
  return "the multibody in slot " + std::to_string(index);
}

}  // namespace

btMultiBodyDynamicsWorld& Side::multibody_world(std::size_t index) const {
  return static_cast<btMultiBodyDynamicsWorld&>(*worlds_[index]->world);
}

void Side::apply_to_multibody(const Operation& operation) {
  const std::size_t index = operation.slot % kMultibodies;
  MultibodySlot& slot = multibodies_[index];
  if (operation.kind == Kind::add_multibody) {
    if (slot.multibody() != nullptr) return;
    slot.make(operation, *shapes_[operation.other % 4], *shapes_[1]);
    put(slot, operation.world);
    return;
  }
  if (slot.multibody() == nullptr) return;
  switch (operation.kind) {
    case Kind::take_multibody:
      if (slot.world == MultibodySlot::kLimbo)
        put(slot, operation.world);
      else
        remove(slot);
      return;
    case Kind::erase_multibody:
      remove(slot);
      // A soft body keeps its contacts until the end of the step.
      if (!is_in_step_ || limits_.world_kind != WorldKind::soft_multi_body) slot.destroy();
      return;
    case Kind::choose_for_multibody:
      choose_for_multibody(operation, index);
      return;
    case Kind::pin_multibody:
      pin(operation, slot);
      return;
    default:
      change_multibody(operation, slot);
  }
}

void Side::put(MultibodySlot& slot, std::size_t world) {
  slot.put(multibody_world(world));
  slot.world = static_cast<int>(world);
}

void Side::remove(MultibodySlot& slot) {
  if (slot.multibody() == nullptr || slot.world == MultibodySlot::kLimbo) return;
  slot.take_out(multibody_world(static_cast<std::size_t>(slot.world)));
  slot.world = MultibodySlot::kLimbo;
}

void Side::pin(const Operation& operation, MultibodySlot& slot) {
  if (slot.world == MultibodySlot::kLimbo) return;
  btMultiBodyDynamicsWorld& world = multibody_world(static_cast<std::size_t>(slot.world));
  if (slot.is_pinned()) {
    slot.unpin(world);
    return;
  }
  btRigidBody* partner = nullptr;
  if (operation.other != kSlots) {
    const BodySlot& second = slots_[operation.other];
    const bool is_here = second.body() != nullptr && second.world == slot.world;
    // For a partner that does not move, Bullet reads outside the solver's arrays.
    if (is_here && !second.body()->isStaticOrKinematicObject()) partner = second.body();
  }
  slot.pin(world, operation, partner);
}

void Side::unpin_from(const btRigidBody& body) {
  for (MultibodySlot& slot : multibodies_) {
    if (slot.pinned_to() == &body) slot.unpin(multibody_world(static_cast<std::size_t>(slot.world)));
  }
}

void Side::leave_second_world(MultibodySlot& slot, bool with_bodies) {
  if (slot.world != 1) return;
  slot.unpin(multibody_world(1));
  if (!with_bodies) remove(slot);
  slot.world = MultibodySlot::kLimbo;
}

void Side::choose_for_multibody(const Operation& operation, std::size_t index) {
  RotationControl* const rotation = worlds_[operation.world]->rotation;
  MultibodySlot& slot = multibodies_[index];
  btMultiBody& multibody = *slot.multibody();
  btCollisionObject* const collider = operation.variant % 2 == 0 ? multibody.getBaseCollider() : nullptr;
  const std::size_t variant = operation.variant / 2;
  const Choice choice = !limits_.managed || variant % 4 == 0 ? Choice::released
                        : variant % 4 == 1                   ? Choice::unset
                                                             : Choice::scheme;
  const SchemePointer& scheme = built_in_schemes()[variant / 2 % built_in_schemes().size()];
  const auto choose_for = [&](auto& body) {
    if (choice == Choice::released) rotation->release(body);
    if (choice == Choice::unset) rotation->use_default_scheme(body);
    if (choice == Choice::scheme) rotation->set_scheme(body, scheme);
  };
  bool is_refused = false;
  try {
    if (rotation != nullptr && collider != nullptr) choose_for(*collider);
    if (rotation != nullptr && collider == nullptr) choose_for(multibody);
  } catch (const std::invalid_argument&) {
    is_refused = true;
  }
  if (rotation != nullptr && is_refused == slot.turns_as_one_body())
    fail(name_of(index) + (is_refused ? " was refused a scheme" : " was given a scheme though links move"));
  if (!is_refused) multibody_choices_[operation.world][index] = choice;
}

void Side::forget_choices_of_absent_multibodies(std::size_t world) {
  for (std::size_t i = 0; i < kMultibodies; ++i) {
    const MultibodySlot& slot = multibodies_[i];
    const bool is_there = slot.multibody() != nullptr && slot.world == static_cast<int>(world);
    if (!is_there || !slot.turns_as_one_body()) multibody_choices_[world][i] = Choice::unset;
  }
}

void Side::begin_step_of_multibodies() {
  for (MultibodySlot& slot : multibodies_) {
    if (slot.multibody() == nullptr) continue;
    slot.force = slot.multibody()->getBaseForce();
    slot.torque = slot.multibody()->getBaseTorque();
  }
}

void Side::check_left_as_they_were(bool with_forces) {
  for (std::size_t i = 0; i < kMultibodies; ++i) {
    const MultibodySlot& slot = multibodies_[i];
    if (slot.multibody() == nullptr) continue;
    if (!(slot.present_switches() == slot.switches)) fail("a step changed the switches of " + name_of(i));
    if (!with_forces || slot.world != static_cast<int>(stepped_)) continue;
    // The library resets forces that are not finite.
    if (is_finite(slot.force) && !(slot.multibody()->getBaseForce() == slot.force))
      fail("a step changed the force on " + name_of(i));
    if (is_finite(slot.torque) && !(slot.multibody()->getBaseTorque() == slot.torque))
      fail("a step changed the torque on " + name_of(i));
  }
}

bool Side::is_multibody_expected_to_be_managed(std::size_t world, std::size_t index) const {
  const MultibodySlot& slot = multibodies_[index];
  if (slot.world != static_cast<int>(world) || !worlds_[world]->is_rotated()) return false;
  if (!slot.turns_as_one_body() || slot.multibody()->isBaseStaticOrKinematic()) return false;
  const Choice choice = multibody_choices_[world][index];
  return choice == Choice::scheme || (choice == Choice::unset && has_default_[world]);
}

std::size_t Side::check_multibodies(std::size_t world) {
  check_left_as_they_were(false);
  const RotationControl* const rotation = worlds_[world]->rotation;
  std::size_t managed = 0;
  for (std::size_t i = 0; i < kMultibodies; ++i) {
    MultibodySlot& slot = multibodies_[i];
    if (slot.multibody() == nullptr) continue;
    if (!is_finite(*slot.multibody())) {
      has_left_contract_ = true;
      // Soft bodies push others after the tick callback.
      if (limits_.world_kind == WorldKind::soft_multi_body && slot.is_finite_at_tick)
        slot.left_non_finite = true;
    }
    if (rotation == nullptr) continue;
    const bool is_managed = rotation->manages(*slot.multibody());
    if (is_managed != is_multibody_expected_to_be_managed(world, i))
      fail("manages() is wrong for " + name_of(i) + ": " + (is_managed ? "true" : "false"));
    if (!is_managed) continue;
    ++managed;
    check_multibody(*rotation, i);
  }
  return managed;
}

void Side::check_multibody(const RotationControl& rotation, std::size_t index) {
  const MultibodySlot& slot = multibodies_[index];
  if (!has_taken_step_ || slot.left_non_finite) return;
  const std::string name = name_of(index) + " of the way " + std::to_string(static_cast<int>(way_));
  if (!is_finite(*slot.multibody())) fail(name + " is not finite:" + numbers(*slot.multibody()));
  check_rotation(rotation.rotation_of(*slot.multibody()), name);
}

}  // namespace polhode::fuzz
