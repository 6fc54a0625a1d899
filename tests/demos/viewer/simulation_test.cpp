// The viewer's model without a window: lockstep, steps back, divergence, limits.
#include "viewer/model/simulation.h"

#include <gtest/gtest.h>

#include "demos/viewer/resolved_scenario.h"
#include "world/run.h"

namespace polhode::demos {
namespace {

TEST(Simulation, StepsAllContendersInLockstep) {
  Simulation simulation(resolved_scenario("tumble"), default_contenders());
  for (int step = 0; step < 20; ++step) simulation.step();
  ASSERT_EQ(simulation.size(), 9u);
  for (std::size_t index = 0; index < simulation.size(); ++index) {
    EXPECT_EQ(simulation.shown(index).sample.step, 20);
    EXPECT_EQ(simulation.shown(index).sample.t_s, simulation.shown_t_s());
  }
}

TEST(Simulation, ComputesTheBitsOfAComparison) {
  Scenario short_run = resolved_scenario("floor");
  short_run.duration = 200 * short_run.dt;
  Simulation simulation(short_run,
                        find_contenders({"quaternion", "bullet:implicit_body", "bullet:multibody"}));
  for (int step = 0; step < 200; ++step) simulation.step();
  for (std::size_t index = 0; index < simulation.size(); ++index) {
    const History& history = simulation.run(index).history();
    run(short_run, simulation.run(index).contender(), [&](const Sample& sample) {
      const Sample& shown = history.at(sample.step).sample;
      EXPECT_EQ(shown.state.q_WB.coeffs(), sample.state.q_WB.coeffs());
      EXPECT_EQ(shown.state.L_W, sample.state.L_W);
      EXPECT_EQ(shown.energy_J, sample.energy_J);
    });
  }
}

TEST(Simulation, ShowsTheOthersOfAMultibodysWorld) {
  Simulation simulation(resolved_scenario("floor"), find_contenders({"bullet:none", "bullet:multibody"}));
  for (int step = 0; step < 20; ++step) simulation.step();
  ASSERT_EQ(simulation.shown(1).others.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Pose& other = simulation.shown(1).others[i];
    // The bodies still fall freely.
    EXPECT_LT((other.position_W - simulation.shown(0).others[i].position_W).norm(),
              1e-12);  // measured 1.6e-20
    EXPECT_GT((other.R_WB - simulation.run(1).history().at(0).others[i].R_WB).norm(),
              0.1);  // measured 0.93 and 2.1
  }
}

TEST(Simulation, StepsBackAndForthToTheSameState) {
  Simulation simulation(resolved_scenario("floor"), find_contenders({"exact"}));
  for (int step = 0; step < 10; ++step) simulation.step();
  const Vector3 there_W = simulation.shown(0).sample.state.L_W;
  const Pose other = simulation.shown(0).others.at(1);
  for (int step = 0; step < 10; ++step) EXPECT_TRUE(simulation.step_back());
  EXPECT_EQ(simulation.shown_step(), 0);
  EXPECT_EQ(simulation.shown(0).sample.state.L_W, simulation.run(0).start().state.L_W);
  EXPECT_FALSE(simulation.step_back());
  for (int step = 0; step < 10; ++step) simulation.step();
  EXPECT_EQ(simulation.computed_step(), 10);
  EXPECT_EQ(simulation.shown(0).sample.state.L_W, there_W);
  EXPECT_EQ(simulation.shown(0).others.at(1).R_WB, other.R_WB);
}

TEST(Simulation, KeepsABoundedHistory) {
  Simulation simulation(resolved_scenario("tumble"), find_contenders({"exact", "quaternion"}), 50);
  for (int step = 0; step < 120; ++step) simulation.step();
  EXPECT_EQ(simulation.run(0).history().size(), 50u);
  EXPECT_EQ(simulation.first_kept_step(), 71);
  int back = 0;
  while (simulation.step_back()) ++back;
  EXPECT_EQ(back, 49);
  EXPECT_EQ(simulation.shown(1).sample.step, 71);
}

TEST(Simulation, KeepsFewerStepsOfManyBodies) {
  Scenario scenario = resolved_scenario("tumble");
  EXPECT_EQ(Simulation(scenario, find_contenders({"exact", "quaternion"})).history_capacity(), 20000u);
  scenario.others.assign(199, scenario.body);
  EXPECT_EQ(Simulation(scenario, find_contenders({"exact", "quaternion"})).history_capacity(), 10000u);
}

TEST(Simulation, GoesOnWithTheOthersAfterADivergence) {
  // The matrix also fails in step 36 in polhode_compare, at 1.08 s.
  Simulation simulation(resolved_scenario("dzhanibekov"), find_contenders({"exact", "matrix"}));
  for (int step = 1; step <= 35; ++step) EXPECT_TRUE(simulation.step().empty());
  EXPECT_EQ(simulation.step(), std::vector<std::string>{"matrix"});
  EXPECT_TRUE(simulation.step().empty());
  EXPECT_EQ(simulation.shown(0).sample.step, 37);
  EXPECT_EQ(simulation.shown(1).sample.step, 35);
  EXPECT_TRUE(simulation.has_diverged(1));
  EXPECT_FALSE(simulation.all_diverged());
  EXPECT_TRUE(simulation.step_back() && simulation.step_back());
  EXPECT_FALSE(simulation.has_diverged(1));
}

TEST(Simulation, KnowsTheAttitudeErrorWhereTheMotionIsFree) {
  Simulation free(resolved_scenario("tumble"), find_contenders({"exact"}));
  free.step();
  ASSERT_TRUE(free.shown(0).sample.attitude_error_rad.has_value());
  EXPECT_LT(*free.shown(0).sample.attitude_error_rad, 1e-15);  // measured 2e-16
  Simulation on_the_floor(resolved_scenario("floor"), find_contenders({"exact"}));
  EXPECT_FALSE(on_the_floor.shown(0).sample.attitude_error_rad.has_value());
}

}  // namespace
}  // namespace polhode::demos
