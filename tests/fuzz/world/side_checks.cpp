#include <LinearMath/btTransformUtil.h>

#include <cmath>
#include <string>

#include "fuzz/fail.h"
#include "fuzz/world/side.h"
#include "fuzz/world/usable_numbers.h"

namespace polhode::fuzz {

namespace {

bool is_rotation(const btMatrix3x3& basis) {
  const btMatrix3x3 product = basis * basis.transpose();
  const btMatrix3x3 identity = btMatrix3x3::getIdentity();
  for (int row = 0; row < 3; ++row) {
    if (!((product[row] - identity[row]).length() < btScalar(1e-3))) return false;
  }
  return true;
}

// Bullet switches a body off if its bounding box is too large. It does so within the step: after a
// RotationWorld has begun the step, and before a RotationPlugin has.
bool is_switched_off_by_bullet(const btRigidBody& body) {
  constexpr btScalar kFast = btScalar(1e5);
  return body.getActivationState() == DISABLE_SIMULATION && body.getLinearVelocity().length() > kFast;
}

bool keeps_no_rotation(const RotationControl& rotation, const btRigidBody& body) {
  const SchemePointer scheme = find_scheme(rotation.rotation_of(body).scheme);
  return scheme->description().rotation == Conservation::lost;
}

}  // namespace

bool Side::is_expected_to_be_managed(std::size_t world, std::size_t slot) const {
  const BodySlot& candidate = slots_[slot];
  if (candidate.body() == nullptr || candidate.world != static_cast<int>(world)) return false;
  if (!worlds_[world]->is_rotated() || candidate.body()->isStaticOrKinematicObject()) return false;
  const Choice choice = choices_[world][slot];
  return choice == Choice::scheme || (choice == Choice::unset && has_default_[world]);
}

void Side::check(std::size_t world) {
  World& checked = *worlds_[world];
  for (std::size_t i = 0; i < kSlots; ++i) {
    BodySlot& slot = slots_[i];
    if (slot.body() == nullptr) continue;
    if (!is_finite(*slot.body()) || is_switched_off_by_bullet(*slot.body())) has_left_contract_ = true;
    // Soft bodies push rigid bodies after the tick callback.
    if (has_soft_bodies(limits_.world_kind) && slot.is_finite_at_tick && !is_finite(*slot.body()))
      slot.left_non_finite = true;
    if (slot.body()->getFlags() != slot.flags) fail("a step changed the flags of a body");
  }
  const std::size_t managed_multibodies = check_multibodies(world);
  if (checked.rotation == nullptr) return;
  for (std::size_t i = 0; i < kSlots && !has_acted_in_motion_state_; ++i) {
    if (slots_[i].body() != nullptr && slots_[i].world == static_cast<int>(world))
      check_motion_state(checked, i);
  }
  std::size_t managed = managed_multibodies;
  for (std::size_t i = 0; i < kSlots; ++i) {
    if (slots_[i].body() == nullptr) continue;
    const bool is_managed = checked.rotation->manages(*slots_[i].body());
    if (is_managed != is_expected_to_be_managed(world, i))
      fail("manages() is wrong for the body in slot " + std::to_string(i) + ": " +
           (is_managed ? "true" : "false"));
    if (!is_managed) continue;
    ++managed;
    check_body(world, i);
  }
  if (checked.rotation->managed_bodies() != managed)
    fail("managed_bodies() is not the number of managed bodies");
  const std::uint64_t incidents = checked.rotation->incidents();
  if (incidents < checked.incidents) fail("incidents() has fallen");
  if (incidents < checked.reports) fail("more incidents were reported than counted");
  checked.incidents = incidents;
}

void Side::check_body(std::size_t world, std::size_t index) {
  const BodySlot& slot = slots_[index];
  if (!has_taken_step_) return;  // dt may be 0 or shorter than a substep
  const std::string name = "the managed body in slot " + std::to_string(index);
  if (!is_finite(*slot.body()) && !slot.left_non_finite)
    fail(name + " of the way " + std::to_string(static_cast<int>(way_)) +
         " is not finite:" + numbers(*slot.body()));
  if (slot.left_non_finite) return;
  check_rotation(worlds_[world]->rotation->rotation_of(*slot.body()), name);
}

void Side::check_rotation(const BodyRotation& rotation, const std::string& name) const {
  if (!rotation.state.all_finite()) fail("rotation_of " + name + " is not finite");
  constexpr double kRounding = 1e-5;
  if (std::abs(rotation.state.q_WB.norm() - 1) > kRounding)
    fail("q_WB of " + name + " is not of unit length");
  if (rotation.unresolved_steps > rotation.steps) fail(name + " has more unresolved steps than steps");
  if (!std::isfinite(rotation.energy_J)) fail("the energy of " + name + " is not finite");
  if (find_scheme(rotation.scheme)->description().name != rotation.scheme)
    fail(name + " has an unknown scheme");
}

// Checks that a motion state gets the pose that Bullet interpolates, or the swollen basis of schemes that
// keep one.
void Side::check_motion_state(const World& world, std::size_t index) {
  const btRigidBody& body = *slots_[index].body();
  const ShownPose* motion_state = slots_[index].motion_state.get();
  if (motion_state == nullptr || !body.isActive() || body.isStaticOrKinematicObject()) return;
  const std::string name = "the motion state of the body in slot " + std::to_string(index);
  if (!motion_state->is_shown && has_taken_step_) fail(name + " did not get a pose");
  if (!motion_state->is_shown) return;
  const btScalar time = world.interpolation_time(body);
  const btTransform& start = body.getInterpolationWorldTransform();
  const btVector3& velocity = body.getInterpolationLinearVelocity();
  btTransform expected;
  btTransformUtil::integrateTransform(start, velocity, body.getInterpolationAngularVelocity(), time,
                                      expected);
  if (!is_finite(expected.getBasis()) || !is_finite(expected.getOrigin())) return;
  const btTransform& shown = motion_state->pose;
  if (!is_finite(shown.getBasis()) || !is_finite(shown.getOrigin())) fail(name + " is not finite");
  constexpr btScalar kRounding = btScalar(1e-5);
  const btScalar size = 1 + start.getOrigin().length() + velocity.length() * std::abs(time);
  if ((shown.getOrigin() - expected.getOrigin()).length() > kRounding * size)
    fail(name + " of the way " + std::to_string(static_cast<int>(way_)) +
         " got another position than Bullet's: " + text(shown.getOrigin()) + " for" +
         text(expected.getOrigin()) + " at the time " + std::to_string(time));
  // A basis that the application set within the step is shown unchanged; Bullet would make it a rotation.
  if (!is_rotation(start.getBasis())) return;
  if (world.rotation->manages(body) && keeps_no_rotation(*world.rotation, body)) return;
  for (int row = 0; row < 3; ++row) {
    if ((shown.getBasis()[row] - expected.getBasis()[row]).length() > kRounding)
      fail(name + " of the way " + std::to_string(static_cast<int>(way_)) +
           " got another orientation than Bullet's: row " + std::to_string(row) +
           text(shown.getBasis()[row]) + " for" + text(expected.getBasis()[row]) + ", from" +
           text(start.getBasis()[row]) + " at the time " + std::to_string(time) + " turning by" +
           text(body.getInterpolationAngularVelocity()));
  }
}

}  // namespace polhode::fuzz
