// A user's actions on a session.
#include "viewer/model/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "demos/support_files.h"
#include "demos/viewer/resolved_scenario.h"
#include "record/csv.h"
#include "viewer/model/changes.h"
#include "viewer/model/csv_export.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;

constexpr std::chrono::seconds kPlenty{60};

TEST(PlaybackClock, CountsRealTimeTimesTheSpeed) {
  PlaybackClock clock;
  EXPECT_EQ(clock.steps_due(0.05, 0.02), 2);
  EXPECT_EQ(clock.steps_due(0.01, 0.02), 1);  // with the fraction kept
  clock.faster();
  EXPECT_EQ(clock.steps_due(0.05, 0.02), 5);
  clock.slower();
  clock.slower();
  clock.restart();
  EXPECT_EQ(clock.steps_due(0.05, 0.02), 1);
}

TEST(PlaybackClock, DoesNotRaceAfterTimeThatWasLost) {
  PlaybackClock clock;
  EXPECT_EQ(clock.steps_due(1e9, 0.01), 10);
  for (int i = 0; i < 100; ++i) clock.faster();
  EXPECT_EQ(clock.speed(), PlaybackClock::kFastest);
}

TEST(Session, HasANoticeOfOnePrintableLine) {
  Session session(resolved_scenario("tumble"), find_contenders({"exact"}));
  session.set_notice("written: a\x1b[2J\n\u202e.csv");
  EXPECT_EQ(session.notice(), "written: a\\x1b[2J\\x0a\\xe2\\x80\\xae.csv");
  session.set_notice(std::string(100000, 'a'));
  EXPECT_LT(session.notice().size(), 1010u);  // measured 1005
}

TEST(Session, PlaysOnlyWhileItRuns) {
  Session session(resolved_scenario("tumble"), find_contenders({"exact"}));
  session.advance(0.1, kPlenty);
  EXPECT_EQ(session.simulation().shown_step(), 0);
  session.apply(Action::run_or_pause);
  session.advance(0.1, kPlenty);
  EXPECT_EQ(session.simulation().shown_step(), 6);
  session.apply(Action::run_or_pause);
  session.advance(0.1, kPlenty);
  EXPECT_EQ(session.simulation().shown_step(), 6);
}

TEST(Session, PausesAtADivergenceAndSaysSo) {
  Session session(resolved_scenario("dzhanibekov"), find_contenders({"exact", "matrix"}));
  session.apply(Action::run_or_pause);
  for (int i = 0; i < 100; ++i) session.advance(0.1, kPlenty);
  EXPECT_FALSE(session.is_running());
  EXPECT_EQ(session.simulation().shown_step(), 36);
  EXPECT_THAT(session.notice(), HasSubstr("matrix diverged at t = 1.08 s"));
  session.apply(Action::run_or_pause);
  session.advance(0.1, kPlenty);
  EXPECT_EQ(session.simulation().shown_step(), 39);
}

TEST(Session, DoesNotRunOnceAllHaveDiverged) {
  Session session(resolved_scenario("dzhanibekov"), find_contenders({"matrix"}));
  session.run_to(100);
  session.apply(Action::run_or_pause);
  EXPECT_FALSE(session.is_running());
  EXPECT_THAT(session.notice(), HasSubstr("R starts over"));
}

TEST(Session, StepsBackStepsAndResets) {
  Session session(resolved_scenario("tumble"), find_contenders({"exact"}), 10);
  session.apply(Action::step_back);
  EXPECT_EQ(session.notice(), "this is the start");
  session.run_to(30);
  for (int i = 0; i < 20; ++i) session.apply(Action::step_back);
  EXPECT_EQ(session.simulation().shown_step(), 21);
  EXPECT_THAT(session.notice(), HasSubstr("older steps are not kept (10 are)"));
  session.apply(Action::step);
  EXPECT_EQ(session.simulation().shown_step(), 22);
  session.apply(Action::reset);
  EXPECT_EQ(session.simulation().shown_step(), 0);
  EXPECT_EQ(session.simulation().computed_step(), 0);
}

TEST(Session, ComputesNoLongerThanItsBudget) {
  Session session(resolved_scenario("tumble"), find_contenders({"exact"}));
  session.clock().set_speed(PlaybackClock::kFastest);
  session.apply(Action::run_or_pause);
  session.advance(0.1, std::chrono::nanoseconds(0));
  EXPECT_EQ(session.simulation().shown_step(), 1);
  EXPECT_TRUE(session.is_late());
}

TEST(Session, StartsOverWithChangesOrSaysWhatIsWrongWithThem) {
  Session session(resolved_scenario("tumble"), find_contenders({"exact"}));
  session.run_to(5);
  Changes changes = changes_of(session.simulation().scenario());
  changes.omega_W = {0, 0, 7};
  session.restart(changed(session.simulation().scenario(), changes), session.contenders(), "changed");
  EXPECT_EQ(session.simulation().shown_step(), 0);
  EXPECT_EQ(session.simulation().run(0).start().state.omega_W.z(), 7.0);
  EXPECT_EQ(session.generation(), 1);

  changes.inertia_B.x() = -1.0;
  EXPECT_THROW(changed(session.simulation().scenario(), changes), std::invalid_argument);
  changes.inertia_B.x() = 1.0;
  changes.omega_W = {9e8, 9e8, 0};  // each is valid, together they are too fast
  session.restart(changed(session.simulation().scenario(), changes), session.contenders(), "changed");
  EXPECT_THAT(session.notice(), HasSubstr("not changed: "));
  EXPECT_EQ(session.simulation().run(0).start().state.omega_W.z(), 7.0);
}

TEST(Session, IsExportedAsThatWhichWasComputed) {
  Session session(resolved_scenario("tumble"), find_contenders({"exact", "matrix"}));
  session.run_to(3);
  session.apply(Action::step_back);
  const TemporaryDirectory directory;
  export_csv(session.simulation(), directory / "out.csv");
  std::string expected = csv_header();
  for (std::size_t index = 0; index < 2; ++index) {
    const ContenderRun& run = session.simulation().run(index);
    for (int step = 0; step <= 2; ++step) {
      expected += csv_row(run.contender().name, run.instant(step));
    }
  }
  EXPECT_EQ(read_file(directory / "out.csv"), expected);
}

TEST(Session, LeavesOutContendersThatCannotRunAnotherScenario) {
  Session session(resolved_scenario("tumble"), find_contenders({"exact", "matrix"}));
  session.change_scenario(resolved_scenario("bicycle_wheel"));
  EXPECT_EQ(session.simulation().scenario().name, "bicycle_wheel");
  ASSERT_EQ(session.contenders().size(), 1u);
  EXPECT_EQ(session.contenders().front().name, "exact");
  EXPECT_EQ(session.notice(), "bicycle_wheel from its start; left out, since they take no rotors: matrix");

  Session without_any(resolved_scenario("tumble"), find_contenders({"matrix"}));
  without_any.change_scenario(resolved_scenario("bicycle_wheel"));
  EXPECT_EQ(without_any.contenders().size(), default_contenders().size() - 1);
}

TEST(Session, KeepsItsContendersWhereOneTakesNoRotors) {
  Session session(resolved_scenario("bicycle_wheel"), find_contenders({"exact"}));
  session.restart(session.simulation().scenario(), find_contenders({"exact", "matrix"}), "another");
  EXPECT_THAT(session.notice(), testing::StartsWith("not changed: contender \"matrix\" takes no rotors"));
  EXPECT_EQ(session.contenders().size(), 1u);
}

}  // namespace
}  // namespace polhode::demos
