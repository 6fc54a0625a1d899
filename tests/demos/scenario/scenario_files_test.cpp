// The files in demos/scenarios contain what their descriptions say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "demos/scenario_file.h"
#include "oracle/heavy_top.h"
#include "scenario/start_motion.h"

namespace polhode::demos {
namespace {

class ScenarioFile : public testing::TestWithParam<std::string> {};

TEST_P(ScenarioFile, IsReadAndNamedAndDescribed) {
  const Scenario scenario = scenario_file(GetParam());
  EXPECT_EQ(scenario.name, GetParam());
  EXPECT_FALSE(scenario.description.empty());
}

INSTANTIATE_TEST_SUITE_P(Each, ScenarioFile,
                         testing::Values("cube_expansion", "dzhanibekov", "t_handle", "tumble", "heavy_top",
                                         "fast_spinner", "floor", "osrf_boxes", "osrf_boxes_simple",
                                         "gravity_gradient", "wheel_stops_the_flip", "reaction_wheels",
                                         "explorer_1", "bicycle_wheel"),
                         [](const auto& file) { return file.param; });

TEST(ScenarioFiles, CubeExpansionIsTheHandoutsCube) {
  const Scenario scenario = scenario_file("cube_expansion");
  const Vector3 L_W =
      scenario.body.inertia_B->cwiseProduct(start_motion(scenario.body, *scenario.body.inertia_B).omega_W);
  EXPECT_LT((L_W - Vector3(0, 20, -20)).norm(), 1e-14);  // measured 0
  EXPECT_EQ(*scenario.body.inertia_B, Vector3::Constant(2.0 / 3.0));
  EXPECT_EQ(std::get<Box>(scenario.body.shape).half_extents, Vector3(1, 1, 1));
  EXPECT_EQ(scenario.dt, 0.001);
}

TEST(ScenarioFiles, DzhanibekovIsTheHandoutsT) {
  const Scenario scenario = scenario_file("dzhanibekov");
  EXPECT_EQ(*scenario.body.inertia_B, Vector3(24.1449, 28.436, 118.812));
  EXPECT_EQ(scenario.body.omega_W, Vector3(0.1, 10, 0));
  EXPECT_EQ(scenario.dt, 0.03);
}

TEST(ScenarioFiles, TumbleHasThreeMoments) {
  const Scenario scenario = scenario_file("tumble");
  EXPECT_EQ(*scenario.body.inertia_B, Vector3(1, 2, 3));
  EXPECT_EQ(scenario.body.omega_W, Vector3(3, 2, 4));
  EXPECT_EQ(scenario.dt, 1.0 / 60.0);
}

TEST(ScenarioFiles, FastSpinnerTurnsPastTheCut) {
  const Scenario scenario = scenario_file("fast_spinner");
  EXPECT_EQ(*scenario.body.inertia_B, Vector3(0.4, 0.5, 0.8));
  EXPECT_EQ(scenario.body.omega_W.norm(), 200.0);
  EXPECT_EQ(scenario.dt, 1.0 / 60.0);
}

TEST(ScenarioFiles, FloorHasAnotherSpinningBodyAndAGround) {
  const Scenario scenario = scenario_file("floor");
  EXPECT_TRUE(std::holds_alternative<Compound>(scenario.body.shape));
  ASSERT_EQ(scenario.others.size(), 2u);
  for (const Body& other : scenario.others) EXPECT_GT(other.omega_W.norm(), 1.0);
  EXPECT_GT(scenario.ground.value().friction, 0.0);
  EXPECT_EQ(scenario.dt, 1.0 / 240.0);
}

TEST(ScenarioFiles, OsrfBoxesAreTheBenchmarksBox) {
  for (const char* name : {"osrf_boxes", "osrf_boxes_simple"}) {
    const Scenario scenario = scenario_file(name);
    EXPECT_EQ(2.0 * std::get<Box>(scenario.body.shape).half_extents, Vector3(0.1, 0.4, 0.9)) << name;
    EXPECT_EQ(scenario.body.mass, 10.0) << name;
    EXPECT_EQ(scenario.duration, 10.0) << name;
  }
  EXPECT_EQ(scenario_file("osrf_boxes").body.omega_W, Vector3(0.1, 5, 0.1));
  EXPECT_EQ(scenario_file("osrf_boxes_simple").body.omega_W, Vector3(0.5, 0, 0));
}

TEST(ScenarioFiles, HeavyTopStartsInItsSteadySlowPrecession) {
  const Scenario scenario = scenario_file("heavy_top");
  const double tilt = 0.5, spin = 20.0;
  const oracle::HeavyTop top = {0.005, 0.008, 1.0, 0.05, 9.81};
  EXPECT_NEAR(oracle::slow_precession(top, tilt, spin), 3.598, 5e-4);  // measured 3.59823
  const oracle::SteadyTop steady = oracle::steadily_precessing(top, tilt, spin);

  const Body& body = scenario.body;
  EXPECT_EQ(*body.inertia_B, Vector3(top.transverse, top.transverse, top.axial));
  EXPECT_EQ(body.mass, top.mass);
  EXPECT_EQ(scenario.gravity_W, Vector3(0, 0, -top.gravity));
  EXPECT_EQ(scenario.constraint.value().pivot_B, Vector3(0, 0, -top.length));
  EXPECT_LT((body.position_W - top.length * steady.axis_W).norm(), 1e-16);  // measured 0
  EXPECT_LT((body.q_WB * Vector3::UnitZ() - steady.axis_W).norm(), 1e-15);  // measured 1.6e-16
  EXPECT_LT((body.omega_W - steady.omega_W).norm(), 1e-14);                 // measured 0
  EXPECT_LT((body.velocity_W - steady.velocity_W).norm(), 1e-16);           // measured 0
  EXPECT_NEAR(body.omega_W.dot(steady.axis_W), spin, 1e-14);                // measured 0
  EXPECT_EQ(scenario.solver_iterations, 50);
  EXPECT_EQ(scenario.dt, 1.0 / 240.0);
}

}  // namespace
}  // namespace polhode::demos
