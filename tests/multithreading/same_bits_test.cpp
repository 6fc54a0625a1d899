// Results are bit-identical for any number of threads.
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolverMt.h>
#include <gtest/gtest.h>

#include "multithreading/plays.h"

namespace polhode::testing {
namespace {

constexpr int kContactsOfPiles = 200;
constexpr int kContactsOfLargeIsland = 20;

// Sets the number of contacts above which Bullet's parallel solver splits an island into batches. The
// default, 250, is more than a pile has.
class LargeIslandsFrom {
 public:
  explicit LargeIslandsFrom(int contacts) : before_(limit()) { limit() = contacts; }
  ~LargeIslandsFrom() { limit() = before_; }
  LargeIslandsFrom(const LargeIslandsFrom&) = delete;
  LargeIslandsFrom& operator=(const LargeIslandsFrom&) = delete;

 private:
  static int& limit() { return btSequentialImpulseConstraintSolverMt::s_minimumContactManifoldsForBatching; }

  int before_;
};

void expect_the_same_for_all_schedulers(const Play& play, Way way, BulletParts parts) {
  const Outcome expected = run(play, way, parts, one_thread());
  for (const SchedulerChoice& scheduler : other_schedulers()) {
    const Outcome actual = run(play, way, parts, scheduler);
    EXPECT_EQ(first_step_that_differs(actual, expected), 0) << scheduler.name;
    EXPECT_EQ(actual.counted_incidents, expected.counted_incidents) << scheduler.name;
    EXPECT_TRUE(actual.incidents == expected.incidents) << scheduler.name;
  }
}

class BothWaysInMt : public ::testing::TestWithParam<Way> {};

std::string way_name(const ::testing::TestParamInfo<Way>& info) {
  return to_string(info.param);
}

INSTANTIATE_TEST_SUITE_P(SameBits, BothWaysInMt, ::testing::Values(Way::rotation_world, Way::rotation_plugin),
                         way_name);

// Without contacts, all of Bullet's parallel parts can be used.
TEST_P(BothWaysInMt, FreeBodiesForAnyNumberOfThreads) {
  expect_the_same_for_all_schedulers(free_bodies(), GetParam(), {true, true});
}

// With contacts, Bullet's results are reproducible only with the sequential narrowphase:
// btCollisionDispatcherMt lists the contacts thread by thread, and the solver takes them in that order.
TEST_P(BothWaysInMt, PilesWithASolverForEachIsland) {
  expect_the_same_for_all_schedulers(piles(), GetParam(), {false, false});
}

TEST_P(BothWaysInMt, PilesWithTheParallelSolver) {
  const LargeIslandsFrom few_contacts(kContactsOfLargeIsland);
  expect_the_same_for_all_schedulers(piles(), GetParam(), {false, true});
}

TEST_P(BothWaysInMt, PilesWithTheParallelNarrowphaseRunToTheirEnd) {
  const LargeIslandsFrom few_contacts(kContactsOfLargeIsland);
  const Outcome outcome = run(piles(), GetParam(), {true, true}, four_threads());
  EXPECT_EQ(outcome.digests.size(), static_cast<std::size_t>(piles().steps));
  EXPECT_GE(outcome.contacts_at_end, kContactsOfPiles);
}

// Checks what the tests of piles assume about plain Bullet.
class PlainBullet : public ::testing::TestWithParam<BulletParts> {};

TEST_P(PlainBullet, GivesTheSameBitsOfPilesIfTheNarrowphaseIsSequential) {
  const LargeIslandsFrom few_contacts(kContactsOfLargeIsland);
  expect_the_same_for_all_schedulers(piles(), Way::plain_bullet, GetParam());
  EXPECT_GE(run(piles(), Way::plain_bullet, GetParam(), one_thread()).contacts_at_end, kContactsOfPiles);
}

INSTANTIATE_TEST_SUITE_P(SameBits, PlainBullet,
                         ::testing::Values(BulletParts{false, false}, BulletParts{false, true}),
                         [](const auto& parameter) { return to_string(parameter.param); });

}  // namespace
}  // namespace polhode::testing
