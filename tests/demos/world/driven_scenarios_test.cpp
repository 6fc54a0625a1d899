// Compares the scenarios of torque laws and rotors with theory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "demos/scenario_file.h"
#include "demos/world/contender.h"
#include "world/run.h"

namespace polhode::demos {
namespace {

std::vector<Sample> samples_of(const Scenario& scenario, const std::string& name) {
  std::vector<Sample> samples;
  run(scenario, contender(name), [&](const Sample& sample) { samples.push_back(sample); });
  return samples;
}

Vector3 axis_W(const Sample& sample, int axis) {
  return sample.state.q_WB * Vector3::Unit(axis);
}

/// Returns the cosine of the angle between an axis of the body and L.
double cosine_to_L(const Sample& sample, int axis) {
  return axis_W(sample, axis).dot(sample.state.L_W.normalized());
}

double signed_angle(const Vector3& from, const Vector3& to, const Vector3& about) {
  return std::atan2(from.cross(to).dot(about), from.dot(to));
}

// Returns the angle of the satellite's long axis from the vertical, in the plane of the orbit.
double pitch(const Sample& sample) {
  return signed_angle(sample.position_W.normalized(), axis_W(sample, 0), Vector3::UnitZ());
}

/// Returns the frequency from the first to the last passage through 0, rad/s.
double frequency(const std::vector<Sample>& samples) {
  std::vector<double> passages_s;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double before = pitch(samples[i - 1]), after = pitch(samples[i]);
    if (before * after >= 0.0) continue;
    passages_s.push_back(samples[i].t_s - after / (after - before) * (samples[i].t_s - samples[i - 1].t_s));
  }
  return M_PI * static_cast<double>(passages_s.size() - 1) / (passages_s.back() - passages_s.front());
}

double largest_yaw(const std::vector<Sample>& samples) {
  double largest = 0.0;
  for (const Sample& sample : samples) {
    const Vector3 along_orbit_W = Vector3::UnitZ().cross(sample.position_W.normalized());
    largest = std::max(largest, std::abs(std::asin(axis_W(sample, 2).dot(along_orbit_W))));
  }
  return largest;
}

TEST(GravityGradientScenario, SwingsAtTheFrequencyOfTheTheory) {
  const Scenario scenario = scenario_file("gravity_gradient");
  const auto planet = std::get<GravityGradient>(scenario.body.drive.law.value());
  const double orbit = std::sqrt(planet.mu / std::pow(scenario.body.position_W.norm(), 3));
  const Vector3& inertia_B = *scenario.body.inertia_B;  // yaw, roll, pitch
  const double expected = orbit * std::sqrt(3.0 * (inertia_B.y() - inertia_B.x()) / inertia_B.z());
  const std::vector<Sample> exact = samples_of(scenario, "exact");
  EXPECT_NEAR(frequency(exact) / expected, 1.0, 1e-3);  // measured 3.6e-4: the amplitude is not 0
  EXPECT_NEAR(exact.back().position_W.norm() / scenario.body.position_W.norm(), 1.0, 1e-4) << "a circle";
  EXPECT_LT(largest_yaw(exact), 0.07);  // measured 0.061
  EXPECT_GT(largest_yaw(samples_of(scenario, "bullet:none")), 0.5)
      << "roll and yaw need the gyroscopic term";  // measured 0.98
}

TEST(WheelStopsTheFlipScenario, FlipsOnceTheWheelStands) {
  const Scenario scenario = scenario_file("wheel_stops_the_flip");
  const double braked_s = scenario.body.drive.motor_torques.front().from_s;
  double before = 1.0, after = 1.0;
  const std::vector<Sample> samples = samples_of(scenario, "exact");
  for (const Sample& sample : samples) {
    double& least = sample.t_s <= braked_s ? before : after;
    least = std::min(least, cosine_to_L(sample, 0));
  }
  EXPECT_GT(before, 0.999);  // measured 0.9999
  EXPECT_LT(after, -0.99);   // measured -0.9998
  EXPECT_LT(samples.back().state.rotor_momentum_B.norm(), 1e-6) << "the wheel stands";
  EXPECT_LT((samples.back().state.L_W - samples.front().state.L_W).norm(), 1e-12) << "of both together";
}

TEST(ReactionWheelsScenario, TurnsTheSatelliteByARightAngleAndStopsIt) {
  const std::vector<Sample> samples = samples_of(scenario_file("reaction_wheels"), "exact");
  const Sample& stopped = samples[15 * 20];
  EXPECT_NEAR(stopped.t_s, 15.0, 1e-9);
  EXPECT_NEAR(samples.front().state.omega_W.norm(), 1.0, 1e-3);
  EXPECT_LT(stopped.state.omega_W.norm(), 0.05);         // measured 0.034: the initial transverse spin
  EXPECT_LT(samples.back().state.omega_W.norm(), 0.05);  // measured 0.038
  EXPECT_NEAR(stopped.state.q_WB.angularDistance(samples.back().state.q_WB), M_PI / 2,
              0.05);  // measured 0.016
}

TEST(Explorer1Scenario, EndsAboutTheAxisOfGreatestInertia) {
  const Scenario scenario = scenario_file("explorer_1");
  const std::vector<Sample> exact = samples_of(scenario, "exact");
  EXPECT_GT(std::abs(cosine_to_L(exact.front(), 2)), 0.9999);
  EXPECT_GT(std::abs(cosine_to_L(exact.back(), 1)), 0.999);  // measured 0.9999
  const double end_rad_s = exact.front().state.L_W.norm() / (scenario.body.inertia_B->y() + 0.05);
  EXPECT_NEAR(exact.back().state.omega_W.norm(), end_rad_s, 0.001 * end_rad_s);  // measured 1.2e-4 rad/s
  // The energy loss of Bullet's implicit term hides the effect of the damper.
  EXPECT_GT(std::abs(cosine_to_L(samples_of(scenario, "bullet:implicit_body").back(), 2)),
            0.999);  // measured 1
}

double precession(const std::vector<Sample>& samples) {
  double angle = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    angle += signed_angle(axis_W(samples[i - 1], 2), axis_W(samples[i], 2), Vector3::UnitZ());
  }
  return angle / samples.back().t_s;
}

TEST(BicycleWheelScenario, CirclesAtMglOverH) {
  Scenario scenario = scenario_file("bicycle_wheel");
  scenario.duration = 10.0;
  const double torque = scenario.body.mass * -scenario.gravity_W.z() * scenario.constraint->pivot_B.norm();
  const double expected = torque / scenario.body.drive.rotor_momentum_B.norm();
  const std::vector<Sample> exact = samples_of(scenario, "exact");
  EXPECT_NEAR(precession(exact) / expected, 1.0, 0.02);                                 // measured 8e-5
  for (const Sample& sample : exact) EXPECT_LT(std::abs(axis_W(sample, 2).z()), 0.01);  // measured 0.003
  EXPECT_LT(axis_W(samples_of(scenario, "bullet:implicit_body").back(), 2).z(), -0.5)
      << "Bullet's own falls";  // measured -0.70
}

}  // namespace
}  // namespace polhode::demos
