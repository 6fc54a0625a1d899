#include "fuzz/world/comparison.h"

#include <string>

#include "fuzz/fail.h"
#include "support/same_bits.h"

namespace polhode::fuzz {
namespace {

bool same(btScalar a, btScalar b) {
  return testing::same_bits(static_cast<double>(a), static_cast<double>(b));
}

bool same(const btVector3& a, const btVector3& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}

bool same(const btRigidBody& a, const btRigidBody& b) {
  const btTransform& pose_a = a.getWorldTransform();
  const btTransform& pose_b = b.getWorldTransform();
  for (int row = 0; row < 3; ++row) {
    if (!same(pose_a.getBasis()[row], pose_b.getBasis()[row])) return false;
  }
  return same(pose_a.getOrigin(), pose_b.getOrigin()) && same(a.getLinearVelocity(), b.getLinearVelocity()) &&
         same(a.getAngularVelocity(), b.getAngularVelocity()) &&
         a.getActivationState() == b.getActivationState();
}

bool same(const btQuaternion& a, const btQuaternion& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z()) && same(a.w(), b.w());
}

bool same(const btMultiBody& a, const btMultiBody& b) {
  return same(a.getWorldToBaseRot(), b.getWorldToBaseRot()) && same(a.getBasePos(), b.getBasePos()) &&
         same(a.getBaseVel(), b.getBaseVel()) && same(a.getBaseOmega(), b.getBaseOmega()) &&
         a.isAwake() == b.isAwake();
}

bool same(const BodyRotation& a, const BodyRotation& b) {
  return testing::same_bits(a.state, b.state) && a.steps == b.steps &&
         a.unresolved_steps == b.unresolved_steps && a.diverged == b.diverged;
}

// Returns true if both are null, or have the same pose and activation.
bool same(const btCollisionObject* a, const btCollisionObject* b) {
  if (a == nullptr || b == nullptr) return a == b;
  for (int row = 0; row < 3; ++row) {
    if (!same(a->getWorldTransform().getBasis()[row], b->getWorldTransform().getBasis()[row])) return false;
  }
  return same(a->getWorldTransform().getOrigin(), b->getWorldTransform().getOrigin()) &&
         a->getActivationState() == b->getActivationState();
}

bool have_same_colliders(const btMultiBody& a, const btMultiBody& b) {
  if (!same(a.getBaseCollider(), b.getBaseCollider())) return false;
  for (int link = 0; link < a.getNumLinks(); ++link) {
    if (!same(a.getLinkCollider(link), b.getLinkCollider(link))) return false;
  }
  return true;
}

void compare_multibodies(const Side& here, const Side& there, std::size_t world) {
  for (std::size_t i = 0; i < kMultibodies; ++i) {
    const btMultiBody* a = here.multibody(i).multibody();
    const btMultiBody* b = there.multibody(i).multibody();
    if (a == nullptr) continue;
    const std::string name = "the multibody in slot " + std::to_string(i);
    if (!same(*a, *b)) fail("the two ways disagree on " + name + ":\n" + numbers(*a) + "\n" + numbers(*b));
    if (!have_same_colliders(*a, *b)) fail("the two ways disagree on the colliders of " + name);
    if (here.rotation(world) == nullptr || there.rotation(world) == nullptr) continue;
    if (!here.rotation(world)->manages(*a)) continue;
    if (!same(here.rotation(world)->rotation_of(*a), there.rotation(world)->rotation_of(*b)))
      fail("the two ways disagree on the rotation of " + name);
  }
}

}  // namespace

void compare(const Side& here, const Side& there, std::size_t world) {
  for (std::size_t i = 0; i < kSlots; ++i) {
    const btRigidBody* a = here.slot(i).body();
    const btRigidBody* b = there.slot(i).body();
    if (a == nullptr) continue;
    if (!same(*a, *b))
      fail("the two ways disagree on the body in slot " + std::to_string(i) + ":\n" + numbers(*a) + "\n" +
           numbers(*b));
    if (here.rotation(world) == nullptr || there.rotation(world) == nullptr) continue;
    if (!here.rotation(world)->manages(*a)) continue;
    if (!same(here.rotation(world)->rotation_of(*a), there.rotation(world)->rotation_of(*b)))
      fail("the two ways disagree on the rotation of the body in slot " + std::to_string(i));
  }
  compare_multibodies(here, there, world);
  if (here.rotation(world) == nullptr || there.rotation(world) == nullptr) return;
  if (here.rotation(world)->incidents() != there.rotation(world)->incidents())
    fail("the two ways disagree on the number of incidents");
}

}  // namespace polhode::fuzz
