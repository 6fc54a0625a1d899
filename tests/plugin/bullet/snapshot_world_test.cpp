// A restored world takes the same steps, bit for bit, as the run that continued.
#include <gtest/gtest.h>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/precision.h"
#include "support/world_bits.h"

namespace polhode::testing {
namespace {

constexpr btScalar kStep = btScalar(1.0 / 60.0);

template <class Way>
class WorldSnapshot : public ::testing::Test {};
TYPED_TEST_SUITE(WorldSnapshot, BothWays, WayName);

// Boxes with schemes that do not swell, which fall onto a floor and each other, and may sleep.
template <class Way>
void add_sleepy_pile(Way& way, int count = 30) {
  set_gravity(way);
  way.add_floor().setFriction(btScalar(0.6));
  std::mt19937 random(1);
  const char* const schemes[] = {"exact", "implicit_gyroscopic", "bullet", "implicit_midpoint", "quaternion"};
  for (int i = 0; i < count; ++i) {
    const btVector3 origin = vector(uniform(random, -1, 1), uniform(random, -1, 1), 0.6 + 0.6 * i);
    const btVector3 half_extents = vector(uniform(random, 0.2, 0.4), uniform(random, 0.2, 0.4), 0.2);
    btRigidBody& box =
        way.add_box(half_extents, 1, btTransform(btQuaternion(1, 2, btScalar(i), 4).normalized(), origin));
    box.setAngularVelocity(vector(uniform(random, -3, 3), 1, uniform(random, -3, 3)));
    box.forceActivationState(ACTIVE_TAG);
    way.rotation().set_scheme(box, schemes[i % 5]);
  }
}

// Steps to a moment, saves, continues, restores and continues again.
template <class Way>
void expect_same_bits_after_restoring_at(Way& way, const std::vector<int>& moments, int steps) {
  int now = 0;
  for (const int moment : moments) {
    way.step(kStep, moment - now);
    const Snapshot snapshot = way.rotation().save_world();
    const std::uint64_t digest = digest_of(way.world(), way.rotation());
    const auto went_on = run(way, steps, kStep);
    way.rotation().restore_world(snapshot);
    EXPECT_EQ(digest_of(way.world(), way.rotation()), digest);
    EXPECT_EQ(way.rotation().save_world(), snapshot);
    EXPECT_EQ(first_difference(went_on, run(way, steps, kStep)), 0) << "saved at step " << moment;
    way.rotation().restore_world(snapshot);
    now = moment;
  }
}

TYPED_TEST(WorldSnapshot, GoesOnWithTheSameBitsInAPile) {
  TypeParam way;
  add_sleepy_pile(way);
  // While falling, colliding and settling, and with sleeping bodies.
  expect_same_bits_after_restoring_at(way, {1, 20, 60, 120, 240, 600}, 300);
  int sleeping = 0;
  for (const auto& body : way.bodies()) sleeping += body->getActivationState() == ISLAND_SLEEPING ? 1 : 0;
  EXPECT_GT(sleeping, 0);
}

TYPED_TEST(WorldSnapshot, GoesOnWithTheSameBitsWithOrderedPairs) {
  TypeParam way;
  way.world().getDispatchInfo().m_deterministicOverlappingPairs = true;
  add_sleepy_pile(way);
  expect_same_bits_after_restoring_at(way, {20, 120, 600}, 300);
}

TYPED_TEST(WorldSnapshot, GoesOnWithTheSameBitsWithRestingBodiesInTheirOwnTree) {
  TypeParam way;
  way.world().setForceUpdateAllAabbs(false);
  add_sleepy_pile(way);
  expect_same_bits_after_restoring_at(way, {20, 120, 600}, 300);
}

TYPED_TEST(WorldSnapshot, GoesOnWithTheSameBitsOnJoints) {
  TypeParam way;
  add_chain(way, 5);
  add_hinged_rod(way, 20);
  add_gimbal(way, 50);
  add_welded_pair(way, 10);
  add_locked(way, btVector3(1, 0, 1), btVector3(3, 2, 1));
  expect_same_bits_after_restoring_at(way, {1, 50, 300}, 300);
}

TYPED_TEST(WorldSnapshot, IsRestoredIntoATwinOfTheWorld) {
  TypeParam way;
  add_sleepy_pile(way);
  way.step(kStep, 200);
  const Snapshot snapshot = way.rotation().save_world();
  const auto went_on = run(way, 400, kStep);
  TypeParam twin;
  add_sleepy_pile(twin);
  twin.step(kStep, 3);
  twin.rotation().restore_world(snapshot);
  EXPECT_EQ(twin.rotation().save_world(), snapshot);
  EXPECT_EQ(first_difference(went_on, run(twin, 400, kStep)), 0);
}

TYPED_TEST(WorldSnapshot, IsSmall) {
  TypeParam way;
  for (int i = 0; i < 100; ++i) way.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  way.step(kStep);
  // measured 648 and 984 bytes for each body with `exact`, 103 for the world
  EXPECT_EQ(way.rotation().save_world().size(), kDoubleBullet ? 98595u : 65011u);
}

// The first step after restoring works as in the world that was restored into.
TEST(WorldSnapshotOfARotationWorld, IsRestoredUnderAPluginAndBack) {
  const auto build = [](auto& way) {
    add_chain(way, 5);
    add_gimbal(way, 50);
    way.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  };
  InRotationWorld way;
  UnderRotationPlugin other;
  build(way);
  build(other);
  way.step(kStep, 100);
  other.rotation().restore_world(way.rotation().save_world());
  EXPECT_EQ(first_difference(run(way, 300, kStep), run(other, 300, kStep)), 0);
  way.rotation().restore_world(other.rotation().save_world());
  EXPECT_EQ(first_difference(run(way, 300, kStep), run(other, 300, kStep)), 0);
}

TYPED_TEST(WorldSnapshot, IsRestoredAfterBodiesWereRemovedAndAdded) {
  TypeParam way;
  add_sleepy_pile(way);
  way.step(kStep, 100);
  const Snapshot snapshot = way.rotation().save_world();
  WorldOrder order = order_of(way.world());
  const auto went_on = run(way, 300, kStep);
  for (const std::size_t i : {std::size_t(3), std::size_t(7), std::size_t(20)}) {
    way.world().removeRigidBody(way.bodies()[i].get());
    way.step(kStep, 5);
    way.world().addRigidBody(way.bodies()[i].get());
  }
  btRigidBody& guest = way.add_box(btVector3(1, 1, 1), 1, btTransform::getIdentity());
  way.step(kStep, 5);
  EXPECT_THROW(way.rotation().restore_world(snapshot, order), std::invalid_argument);
  way.remove(guest);
  way.rotation().restore_world(snapshot, order);
  EXPECT_EQ(way.rotation().save_world(), snapshot);
  EXPECT_EQ(first_difference(went_on, run(way, 300, kStep)), 0);
}

}  // namespace
}  // namespace polhode::testing
