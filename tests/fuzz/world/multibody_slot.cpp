#include "fuzz/world/multibody_slot.h"

#include <sanitizer/asan_interface.h>

#include <new>

#include "fuzz/world/body_slot.h"
#include "fuzz/world/usable_numbers.h"
#include "support/same_bits.h"

namespace polhode::fuzz {

namespace {

enum class Links : std::uint8_t {
  none,
  none_too,
  none_either,
  one,
  two_at_base,
  two_in_a_row,
  moving,
  fixed_base
};

Links links_of(const Operation& operation) {
  return static_cast<Links>(operation.variant % 8);
}

btVector3 reach(const btVector3& v) {
  const btScalar longest = 1000;
  return is_finite(v) && v.length() < longest ? v : btVector3(1, 0, 0);
}

bool same(btScalar a, btScalar b) {
  return testing::same_bits(static_cast<double>(a), static_cast<double>(b));
}

}  // namespace

std::string numbers(const btMultiBody& multibody) {
  const btQuaternion& q_BW = multibody.getWorldToBaseRot();
  return text(btVector3(q_BW.x(), q_BW.y(), q_BW.z())) + std::to_string(q_BW.w()) + ';' +
         text(multibody.getBasePos()) + text(multibody.getBaseVel()) + text(multibody.getBaseOmega()) +
         " awake " + std::to_string(static_cast<int>(multibody.isAwake()));
}

bool Switches::operator==(const Switches& other) const {
  return gyroscopic_term == other.gyroscopic_term && global_velocities == other.global_velocities &&
         can_sleep == other.can_sleep && same(linear_damping, other.linear_damping) &&
         same(angular_damping, other.angular_damping) && same(largest_velocity, other.largest_velocity);
}

void MultibodySlot::make(const Operation& operation, btCollisionShape& of_base, btCollisionShape& of_links) {
  const Links links = links_of(operation);
  const btScalar mass = inertia(operation.y, false);
  btVector3 inertia_B = moments(operation.b);
  if (operation.variant < 32) of_base.calculateLocalInertia(mass, inertia_B);
  const int count = links == Links::two_at_base || links == Links::two_in_a_row ? 2
                    : links == Links::one || links == Links::moving             ? 1
                                                                                : 0;
  ASAN_UNPOISON_MEMORY_REGION(memory_.data(), memory_.size());
  multibody_ = new (memory_.data())
      btMultiBody(count, mass, inertia_B, links == Links::fixed_base, operation.other % 2 != 0);
  add_links(operation);
  multibody_->finalizeMultiDof();
  multibody_->setBaseWorldTransform(
      btTransform(orientation(btVector3(operation.x, 1, operation.x), 2), operation.a));
  const std::size_t colliders = operation.variant / 8 % 4;
  const int user_index = static_cast<int>(kSlots + operation.slot % kMultibodies);
  if (colliders % 2 == 1) add_collider(-1, of_base, user_index);
  for (int link = 0; link < count && colliders >= 2; ++link) add_collider(link, of_links, user_index);
  switches = present_switches();
}

void MultibodySlot::add_links(const Operation& operation) {
  const Links links = links_of(operation);
  const btScalar mass = inertia(operation.x, false);
  const btVector3 inertia_link = btScalar(0.1) * mass * btVector3(1, 2, 2);
  const btVector3 to_link = reach(operation.b);
  const btQuaternion turn = orientation(operation.b, 1);
  for (int link = 0; link < multibody_->getNumLinks(); ++link) {
    const int parent = links == Links::two_in_a_row ? link - 1 : -1;
    if (links == Links::moving) {
      multibody_->setupRevolute(link, mass, inertia_link, parent, turn, btVector3(0, 1, 0), to_link,
                                btVector3(0, 0, 1), true);
    } else {
      multibody_->setupFixed(link, mass, inertia_link, parent, turn, link == 0 ? to_link : -2 * to_link,
                             btVector3(0, 0, 0));
    }
  }
}

void MultibodySlot::add_collider(int link, btCollisionShape& shape, int user_index) {
  auto collider = std::make_unique<btMultiBodyLinkCollider>(multibody_, link);
  collider->setCollisionShape(&shape);
  collider->setWorldTransform(multibody_->getBaseWorldTransform());
  collider->setUserIndex(user_index);
  if (link < 0)
    multibody_->setBaseCollider(collider.get());
  else
    multibody_->getLink(link).m_collider = collider.get();
  colliders_.push_back(std::move(collider));
}

void MultibodySlot::destroy() {
  if (multibody_ == nullptr) return;
  multibody_->~btMultiBody();
  ASAN_POISON_MEMORY_REGION(memory_.data(), memory_.size());
  multibody_ = nullptr;
  colliders_.clear();
}

void MultibodySlot::put(btMultiBodyDynamicsWorld& home) {
  home.addMultiBody(multibody_);
  for (const auto& collider : colliders_) {
    // Without an explicit group Bullet would filter the collider as a static object.
    home.addCollisionObject(collider.get(), btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  }
}

void MultibodySlot::take_out(btMultiBodyDynamicsWorld& home) {
  unpin(home);
  home.removeMultiBody(multibody_);
  for (const auto& collider : colliders_) home.removeCollisionObject(collider.get());
}

void MultibodySlot::pin(btMultiBodyDynamicsWorld& home, const Operation& operation, btRigidBody* body) {
  const btVector3 point_B = reach(operation.a);
  const btTransform pose = body == nullptr ? btTransform::getIdentity() : body->getWorldTransform();
  const btVector3 there = pose.inverse() * (multibody_->getBaseWorldTransform() * point_B);
  if (!is_finite(there)) return;
  pin_ = std::make_unique<btMultiBodyPoint2Point>(multibody_, -1, body, point_B, there);
  pinned_to_ = body;
  home.addMultiBodyConstraint(pin_.get());
}

void MultibodySlot::unpin(btMultiBodyDynamicsWorld& home) {
  if (pin_ == nullptr) return;
  home.removeMultiBodyConstraint(pin_.get());
  pin_.reset();
  pinned_to_ = nullptr;
}

bool MultibodySlot::turns_as_one_body() const {
  if (multibody_->hasFixedBase() || multibody_->getNumDofs() > 0) return false;
  return multibody_->getNumLinks() == 0 || !multibody_->isUsingGlobalVelocities();
}

Switches MultibodySlot::present_switches() const {
  return {multibody_->getUseGyroTerm(),    multibody_->isUsingGlobalVelocities(),
          multibody_->getCanSleep(),       multibody_->getLinearDamping(),
          multibody_->getAngularDamping(), multibody_->getMaxCoordinateVelocity()};
}

}  // namespace polhode::fuzz
