#include "world/run.h"

#include <LinearMath/btScalar.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "demos/world/contender.h"
#include "polhode/rotation_limits.h"
#include "scenario/scenario_reader.h"

namespace polhode::demos {
namespace {

Scenario tumble(const std::string& more) {
  return parse_scenario(R"({"inertia": [1, 2, 3], )" + more + "}", "tumble.json");
}

std::vector<Sample> samples_of(const Scenario& scenario, const Contender& contender) {
  std::vector<Sample> samples;
  run(scenario, contender, [&](const Sample& sample) { samples.push_back(sample); });
  return samples;
}

TEST(Run, ShowsTheStartAndEveryStep) {
  const Scenario scenario = tumble(R"("angular_velocity": [1, 2, 3], "dt": 0.01, "duration": 0.1)");
  const std::vector<Sample> samples = samples_of(scenario, contender("quaternion"));
  ASSERT_EQ(samples.size(), 11u);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].step, static_cast<std::int64_t>(i));
    EXPECT_EQ(samples[i].t_s, static_cast<double>(i) * 0.01);
  }
}

TEST(Run, StopsASchemeWhereItDiverges) {
  const Scenario scenario = tumble(R"("angular_velocity": [300, 200, 400], "dt": 0.1, "duration": 100)");
  std::vector<Sample> samples;
  const Figures figures = run(scenario, contender("semi_implicit_gyroscopic"),
                              [&](const Sample& sample) { samples.push_back(sample); });
  ASSERT_TRUE(figures.diverged_at_s);
  EXPECT_EQ(*figures.diverged_at_s, static_cast<double>(figures.steps + 1) * 0.1);
  EXPECT_EQ(samples.back().step, figures.steps);
  EXPECT_LT(figures.steps, 10);  // measured 2
  for (const Sample& sample : samples) EXPECT_LE(sample.state.omega_W.norm(), kMaximumAngularSpeed);
}

TEST(Run, StopsBulletWhereItDiverges) {
  // A constant torque on a light body takes it past 1e9 rad/s within the run, with finite numbers.
  const Scenario scenario = parse_scenario(
      R"({"inertia": [1e-3, 1e-3, 1e-3], "torque": [0, 0, 1e6], "dt": 0.1, "duration": 100})", "torque.json");
  std::vector<Sample> samples;
  const Figures figures =
      run(scenario, contender("bullet:none"), [&](const Sample& sample) { samples.push_back(sample); });
  ASSERT_TRUE(figures.diverged_at_s);
  EXPECT_EQ(*figures.diverged_at_s, 11 * 0.1) << "each step adds 1e8 rad/s";
  EXPECT_EQ(samples.back().step, figures.steps);
}

// An Euler step of a sphere turns it by 2 atan(omega dt / 2) instead of omega dt. Tenths are rounded in
// inertia, orientation, velocity and time step; this rounding does not count as an error of the contender.
TEST(Run, MeasuresTheAttitudeAgainstTheExactMotionOfTheBodyAsItIs) {
  const Scenario scenario = parse_scenario(
      R"({"inertia": [0.1, 0.1, 0.1], "orientation": [0.1, 0.2, 0.3, 0.4], "angular_velocity": [1.1, 2.2, 3.3],
          "gravity": [0, 0, -9.81], "dt": 0.1, "duration": 10})",
      "tenths.json");
  const std::vector<Sample> samples = samples_of(scenario, contender("quaternion"));
  const double turn = samples.front().state.omega_W.norm() * static_cast<double>(static_cast<btScalar>(0.1));
  for (const Sample& sample : samples) {
    const double off = static_cast<double>(sample.step) * (turn - 2 * std::atan(turn / 2));
    EXPECT_NEAR(sample.attitude_error_rad.value(), off, 2e-14)
        << sample.step;  // measured 3.4e-15 in single, 5.8e-15 in double
  }
}

TEST(Run, MeasuresTheNearestRotationOfASwollenBasis) {
  const Scenario scenario = tumble(R"("angular_velocity": [3, 2, 4], "dt": 0.001, "duration": 0.1)");
  const Figures figures = run(scenario, contender("matrix"), [](const Sample&) {});
  EXPECT_GT(figures.final_attitude_error_rad.value(), 6e-5);  // measured 6.3e-4
  EXPECT_LT(figures.worst_attitude_error_rad.value(), 6e-3);
}

TEST(Run, HasNoAttitudeErrorWhereTheExactMotionIsNotKnown) {
  const Scenario scenario = tumble(R"("torque": [0, 0, 1], "dt": 0.01, "duration": 0.1)");
  const Figures figures = run(scenario, contender("quaternion"), [](const Sample& sample) {
    EXPECT_FALSE(sample.attitude_error_rad) << sample.step;
  });
  EXPECT_FALSE(figures.final_attitude_error_rad);
  EXPECT_FALSE(figures.worst_attitude_error_rad);
}

TEST(Run, EndsWhenTheObserverThrows) {
  const Scenario scenario = tumble(R"("dt": 0.01, "duration": 0.1)");
  int shown = 0;
  const auto observer = [&](const Sample&) {
    if (++shown == 3) throw std::runtime_error("enough");
  };
  EXPECT_THROW(run(scenario, contender("matrix"), observer), std::runtime_error);
  EXPECT_EQ(shown, 3);
}

TEST(Run, TimesItsSteps) {
  const Scenario scenario = tumble(R"("angular_velocity": [1, 2, 3], "dt": 0.01, "duration": 10)");
  const Figures figures = run(scenario, contender("matrix"), [](const Sample&) {});
  EXPECT_GT(figures.ns_per_step, 10.0);  // measured 1000
  EXPECT_LT(figures.ns_per_step, 1e7);
}

}  // namespace
}  // namespace polhode::demos
