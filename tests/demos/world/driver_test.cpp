#include "world/driver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "demos/world/contender.h"
#include "scenario/scenario_reader.h"
#include "world/run.h"
#include "world/scenario_world.h"

namespace polhode::demos {
namespace {

const double kEpsilon = static_cast<double>(SIMD_EPSILON);

Scenario scenario_of(const std::string& keys) {
  return parse_scenario("{" + keys + "}", "driven.json");
}

const char* const kWithRotors =
    R"("inertia": [1, 2, 3], "orientation": [1, 2, 3, 4], "angular_velocity": [0.5, -1, 2],
       "rotor_momentum": [2, -3, 4])";

Scenario with_rotors(double dt, double duration) {
  return scenario_of(std::string(kWithRotors) + ", \"dt\": " + std::to_string(dt) +
                     ", \"duration\": " + std::to_string(duration));
}

Sample end_of(const Scenario& scenario, const std::string& name) {
  Sample end;
  run(scenario, contender(name), [&](const Sample& sample) { end = sample; });
  return end;
}

class EveryContenderWithRotors : public testing::TestWithParam<std::string> {};

std::vector<std::string> names_with_rotors() {
  std::vector<std::string> names;
  for (const Contender& each : all_contenders()) {
    if (takes_rotors(each)) names.push_back(each.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Each, EveryContenderWithRotors, testing::ValuesIn(names_with_rotors()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), ':', '_');
                           return name;
                         });

TEST_P(EveryContenderWithRotors, StartsWithThem) {
  const Scenario scenario = with_rotors(0.01, 1.0);
  const ScenarioWorld world(scenario, contender(GetParam()));
  const RotationState start = world.sample().value().state;
  const Body& body = scenario.body;
  const Vector3 body_momentum_W =
      body.q_WB * body.inertia_B->cwiseProduct(body.q_WB.conjugate() * body.omega_W);
  const Vector3 L_W = body_momentum_W + body.q_WB * body.drive.rotor_momentum_B;
  // Measured in single precision, for the worst contender, in units of the rounding: 1.2, 2.3 of 4.5, 4.4 of
  // 36 and 0.75.
  EXPECT_LT((start.omega_W - body.omega_W).norm(), 4 * kEpsilon);
  EXPECT_LT((start.rotor_momentum_B - body.drive.rotor_momentum_B).norm(), 8 * kEpsilon * L_W.norm());
  EXPECT_LT((start.L_W - L_W).norm(), 8 * kEpsilon * L_W.norm());
  EXPECT_LT((world.inertia_B() - *body.inertia_B).norm(), 8 * kEpsilon);
  EXPECT_NEAR(start.energy(), 0.5 * body.omega_W.dot(body_momentum_W), 16 * kEpsilon);
}

// The wheels of Bullet's contenders act like the rotors of the library, compared with the oracle.
TEST_P(EveryContenderWithRotors, ConvergesToTheExactMotion) {
  const double error = end_of(with_rotors(1.0 / 512, 1.0), GetParam()).attitude_error_rad.value();
  if (GetParam() == "bullet:none") {
    EXPECT_GT(error, 0.1) << "it has no gyroscopic term";
    return;
  }
  EXPECT_LT(error, 0.2);  // measured 0.06 in the worst, bullet:implicit_world
  if (bullet_precision() == "single") return;
  const double finer = end_of(with_rotors(1.0 / 1024, 1.0), GetParam()).attitude_error_rad.value();
  EXPECT_TRUE(finer < 0.6 * error || finer < 1e-12) << error << " " << finer;
}

TEST_P(EveryContenderWithRotors, GivesThemTheMomentumOfTheirMotors) {
  const Scenario scenario = scenario_of(
      R"("inertia": [1, 1, 1], "dt": 0.0625, "duration": 1,
         "rotor_torque": [{"torque_B": [0, 0, 2], "from": 0.25, "until": 0.75}, {"torque_B": [0, 0, 1]}])");
  const RotationState end = end_of(scenario, GetParam()).state;
  EXPECT_LT((end.rotor_momentum_B - Vector3(0, 0, 2)).norm(),
            1e-5);  // measured 7.6e-7 in single, 9e-16 in double
  EXPECT_LT((end.omega_W - Vector3(0, 0, -2)).norm(), 1e-5);
  EXPECT_LT(end.L_W.norm(), 1e-5);
}

class EveryLaw : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(
    Each, EveryLaw,
    testing::Values(R"({"kind": "gravity_gradient", "mu": 70, "centre": [0, 0, -3]})",
                    R"({"kind": "magnetic_dipole", "dipole_B": [1, 2, 3], "field": [1, -1, 2]})",
                    R"({"kind": "spring", "orientation": [0, 1, 0, 0], "stiffness": 5})",
                    R"({"kind": "rate_damping", "coefficients_B": [1, 0.5, 2]})",
                    R"({"kind": "internal_damping", "moment": 0.4, "coefficient": 1})"),
    [](const auto& test) { return std::to_string(test.index); });

TEST_P(EveryLaw, DrivesBulletsBodiesAsTheLibrarys) {
  const Scenario scenario = scenario_of(R"("inertia": [1, 2, 3], "angular_velocity": [1, 0.5, -1],
      "linear_velocity": [3, 0, 0], "dt": 0.001, "duration": 1, "torque_law": )" +
                                        GetParam());
  const Sample expected = end_of(scenario, "exact");
  Scenario without = scenario;
  without.body.drive.law.reset();
  const double effect = end_of(without, "exact").state.q_WB.angularDistance(expected.state.q_WB);
  EXPECT_GT(effect, 0.1);  // measured 0.24 and more
  for (const char* name : {"bullet:implicit_body", "bullet:multibody"}) {
    if (!takes_rotors(contender(name)) && scenario.has_rotors()) continue;
    const Sample end = end_of(scenario, name);
    EXPECT_LT(end.state.q_WB.angularDistance(expected.state.q_WB), 1e-2) << name;  // measured 3.7e-3 at most
    EXPECT_LT((end.position_W - expected.position_W).norm(), 1e-6) << name;        // measured 6e-8 in single
  }
}

// An elliptic orbit, on which the planet's pull keeps the body.
TEST(Driver, KeepsTheEnergyOfAnOrbit) {
  const Scenario scenario = scenario_of(
      R"("inertia": [1e-3, 2e-3, 3e-3], "position": [10, 0, 0], "linear_velocity": [0, 2.5, 0], "dt": 0.01, "duration": 40,
         "torque_law": {"kind": "gravity_gradient", "mu": 100})");
  const Figures figures = run(scenario, contender("exact"), [](const Sample&) {});
  EXPECT_LT(figures.worst_energy_error.value(), 0.01);  // measured 4.2e-3
}

TEST(Driver, PullsTheWheelsOfABodyToo) {
  const Scenario scenario = scenario_of(
      R"("inertia": [1, 2, 3], "position": [10, 0, 0], "linear_velocity": [0, 2.5, 0], "dt": 0.01, "duration": 4,
         "rotor_momentum": [1, 0, 2], "torque_law": {"kind": "gravity_gradient", "mu": 100})");
  const Vector3 expected_W = end_of(scenario, "exact").position_W;
  EXPECT_LT((end_of(scenario, "bullet:implicit_body").position_W - expected_W).norm(), 1e-4);
}

TEST(Driver, RefusesRotorsForAContenderThatTakesNone) {
  for (const char* keys :
       {R"("rotor_momentum": [0, 0, 1])", R"("rotor_torque": [{"torque_B": [0, 0, 1]}])",
        R"("torque_law": {"kind": "internal_damping", "moment": 0.4, "coefficient": 1})",
        R"("others": [{"inertia": [1, 1, 1], "position": [5, 0, 0], "rotor_momentum": [0, 0, 1]}])"}) {
    const Scenario scenario =
        scenario_of(R"("inertia": [1, 2, 3], "dt": 0.1, "duration": 1, )" + std::string(keys));
    for (const char* name : {"matrix", "bullet:multibody"}) {
      EXPECT_THAT([&] { ScenarioWorld(scenario, contender(name)); },
                  testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("takes no rotors")));
    }
  }
}

TEST(Driver, LetsAWheelLeaveWithItsBody) {
  ContenderWorld world(contender("bullet:implicit_body"));
  auto body = make_scenario_body(world, with_rotors(0.01, 1.0).body);
  EXPECT_EQ(world.world().getNumCollisionObjects(), 4) << "a wheel about each axis";
  EXPECT_EQ(world.world().getNumConstraints(), 3);
  body.reset();
  EXPECT_EQ(world.world().getNumCollisionObjects(), 0);
  EXPECT_EQ(world.world().getNumConstraints(), 0);
}

// Wheels inside a body do not collide with another one.
TEST(Driver, LetsNothingTouchAWheel) {
  const Scenario scenario = scenario_of(
      R"("inertia": [1, 1, 1], "shape": {"type": "sphere", "radius": 0.1}, "rotor_momentum": [0, 0, 1],
         "dt": 0.1, "duration": 1, "others": [{"inertia": [1, 1, 1], "position": [0.3, 0, 0],
         "shape": {"type": "sphere", "radius": 0.1}}])");
  EXPECT_LT(end_of(scenario, "bullet:implicit_body").position_W.norm(), 1e-6);  // measured 0
}

}  // namespace
}  // namespace polhode::demos
