#include "scenario/scenario.h"

#include <gtest/gtest.h>

#include "scenario/scenario_reader.h"

namespace polhode::demos {
namespace {

bool is_torque_free(const std::string& more) {
  return parse_scenario(R"({"inertia": [1, 2, 3], "dt": 0.5, "duration": 10)" + more + "}", "body.json")
      .is_torque_free();
}

TEST(Scenario, IsTorqueFreeAloneInSpaceOrFallingFreely) {
  EXPECT_TRUE(is_torque_free(""));
  EXPECT_TRUE(is_torque_free(R"(, "gravity": [0, 0, -9.81])"));
  EXPECT_TRUE(is_torque_free(R"(, "damping": {"linear": 0.5, "angular": 0})"));
  EXPECT_TRUE(is_torque_free(R"(, "impulses": [{"impulse": [1, 0, 0], "at": [0, 1, 0]}])")) << "at the start";
}

TEST(Scenario, IsNotTorqueFreeWhereSomethingTurnsTheBodyOrMayTouchIt) {
  EXPECT_FALSE(is_torque_free(R"(, "torque": [0, 1e-9, 0])"));
  EXPECT_FALSE(is_torque_free(R"(, "damping": {"linear": 0, "angular": 0.1})"));
  EXPECT_FALSE(is_torque_free(R"(, "constraint": {"type": "point_to_point", "pivot_B": [0, 0, 1]})"));
  EXPECT_FALSE(is_torque_free(R"(, "ground": {})"));
  EXPECT_FALSE(is_torque_free(R"(, "others": [{"inertia": [1, 2, 3], "position": [9, 0, 0]}])"));
}

}  // namespace
}  // namespace polhode::demos
