// Tests the library's torque laws against their formulas and against theory.
#include "polhode/torque_laws.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "polhode/rotation_math.h"
#include "polhode/scheme_registry.h"
#include "scheme_base/driven_step.h"
#include "support/free_motion_reference.h"

namespace polhode {
namespace {

using ::testing::HasSubstr;
using ::testing::Property;
using ::testing::Throws;

const Quaternion kOrientation = Quaternion(0.5, 0.1, -0.7, 0.5).normalized();

TorqueLawInput motion_at(const Vector3& position_W) {
  return {1.5,
          kOrientation,
          Vector3(1.0, -2.0, 0.5),
          position_W,
          Vector3(0.1, 0.2, 0.3),
          {1.0, 2.0, 3.0},
          {0.4, 0.5, 0.6}};
}

Vector3 in_world(const Torque& torque) {
  return torque.world_W + kOrientation * torque.body_B;
}

// 3 mu / r^5 r x I_W r, and the gradient of the potential -3 mu / (2 r^5) r . I_W r + const.
TEST(TorqueLawsThatShip, GravityGradientIsTheSlopeOfItsPotential) {
  const Vector3 centre_W(1.0, 0.0, 2.0);
  const TorqueLawInput motion = motion_at({4.0, -3.0, 1.0});
  const Vector3 torque_W = in_world(gravity_gradient(5.0, centre_W)(motion));
  const Vector3 r_W = motion.position_W - centre_W;
  const auto potential = [&](const Quaternion& q_WB) {
    const Vector3 r_B = q_WB.conjugate() * r_W;
    return 1.5 * 5.0 / std::pow(r_W.norm(), 5) * r_B.dot(motion.inertia_B.cwiseProduct(r_B));
  };
  constexpr double kTurn = 1e-5;
  for (int axis = 0; axis < 3; ++axis) {
    const Quaternion turn = exponential(kTurn * Vector3::Unit(axis));
    const double slope =
        (potential(turn * kOrientation) - potential(turn.conjugate() * kOrientation)) / (2.0 * kTurn);
    EXPECT_NEAR(torque_W[axis], -slope, 1e-9) << axis;
  }
}

TEST(TorqueLawsThatShip, MagneticDipoleTurnsTowardsTheField) {
  const TorqueLawInput motion = motion_at({4.0, -3.0, 1.0});
  const Vector3 field_W(0.1, 0.2, -0.3);
  const Vector3 expected_W = (kOrientation * Vector3(2.0, 0.0, 1.0)).cross(field_W);
  EXPECT_EQ(in_world(magnetic_dipole({2.0, 0.0, 1.0}, field_W)(motion)), expected_W);
  const auto where_it_is = [](const TorqueLawInput& at) { return Vector3(at.time_s * at.position_W); };
  EXPECT_EQ(in_world(magnetic_dipole_in_field({2.0, 0.0, 1.0}, where_it_is)(motion)),
            (kOrientation * Vector3(2.0, 0.0, 1.0)).cross(1.5 * Vector3(4.0, -3.0, 1.0)));
}

TEST(TorqueLawsThatShip, OrientationSpringPullsByTheShortestWay) {
  const Quaternion target = exponential(Vector3(0.3, -0.2, 0.1)).conjugate() * kOrientation;
  const Vector3 torque_W = in_world(orientation_spring(target, 4.0)(motion_at(Vector3::Zero())));
  EXPECT_LE((torque_W - -4.0 * Vector3(0.3, -0.2, 0.1)).norm(), 1e-15);
  // q and -q are the same orientation.
  const Quaternion same(-target.w(), -target.x(), -target.y(), -target.z());
  EXPECT_LE((in_world(orientation_spring(same, 4.0)(motion_at(Vector3::Zero()))) - torque_W).norm(), 1e-15);
}

TEST(TorqueLawsThatShip, DampingOpposesTheVelocity) {
  const TorqueLawInput motion = motion_at(Vector3::Zero());
  EXPECT_LE((in_world(rate_damping(0.5)(motion)) - -0.5 * motion.omega_W).norm(), 1e-15);
  const Torque torque = rate_damping(Vector3(1.0, 2.0, 0.0))(motion);
  EXPECT_LE((torque.body_B - Vector3(-1.0, -2.0, 0.0).cwiseProduct(motion.omega_B())).norm(), 1e-15);
  const Torque inside = internal_damping(0.2, 0.4)(motion);
  EXPECT_LE((inside.rotor_B - 0.4 * (motion.omega_B() - Vector3(2.0, 2.5, 3.0))).norm(), 1e-15);
  EXPECT_TRUE(inside.world_W.isZero(0.0) && inside.body_B.isZero(0.0));
}

TEST(TorqueLawsThatShip, RefuseParametersThatMakeNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(
      [] { gravity_gradient(0.0); },
      Throws<std::invalid_argument>(Property(
          &std::invalid_argument::what, HasSubstr("the gravitational parameter is 0.000000: valid is"))));
  EXPECT_THROW(gravity_gradient(1.0, Vector3(0.0, nan, 0.0)), std::invalid_argument);
  EXPECT_THROW(magnetic_dipole(Vector3(nan, 0.0, 0.0), Vector3::Zero()), std::invalid_argument);
  EXPECT_THROW(magnetic_dipole(Vector3::Zero(), Vector3(0.0, 0.0, nan)), std::invalid_argument);
  EXPECT_THROW(magnetic_dipole_in_field(Vector3::Zero(), nullptr), std::invalid_argument);
  EXPECT_THROW(orientation_spring(Quaternion(0.0, 0.0, 0.0, 0.0), 1.0), std::invalid_argument);
  EXPECT_THROW(orientation_spring(Quaternion::Identity(), -1.0), std::invalid_argument);
  EXPECT_THROW(rate_damping(-0.1), std::invalid_argument);
  EXPECT_THROW(rate_damping(Vector3(0.0, nan, 0.0)), std::invalid_argument);
  EXPECT_THROW(internal_damping(0.0, 1.0), std::invalid_argument);
  EXPECT_THROW(internal_damping(1.0, -1.0), std::invalid_argument);
}

// A satellite in a circular orbit in the x-y plane, with its long axis nearly along the radius. The pitch
// librates at n sqrt(3 (I_roll - I_yaw) / I_pitch) (Hughes 1986).
TEST(TorqueLawsThatShip, GravityGradientLibratesAsTheorySays) {
  const double n = 0.5;                    // rad/s; radius 1 m, so that mu = n^2
  const Vector3 inertia_B(1.0, 2.0, 2.5);  // yaw, roll, pitch
  const double expected = n * std::sqrt(3.0 * (2.0 - 1.0) / 2.5);
  Drive drive;
  drive.law = gravity_gradient(n * n);
  RotationState state = testing::state_from(inertia_B, exponential({0.0, 0.0, 0.01}), {0.0, 0.0, n});
  const double dt = 0.02;
  double before = 0.01;
  double first = 0.0;
  double last = 0.0;
  int crossings = 0;
  for (int i = 0; i < 20000; ++i) {
    const double t = i * dt;
    const Vector3 position_W(std::cos(n * t), std::sin(n * t), 0.0);
    const StepStart start = {t, position_W, n * Vector3(-position_W.y(), position_W.x(), 0.0)};
    const DrivenStep step =
        take_driven_step(*find_scheme("exact"), {inertia_B, Vector3::Zero(), dt}, start, drive, state);
    state = step.end;
    const Quaternion radial = exponential({0.0, 0.0, n * (t + dt)});
    const double pitch = logarithm(radial.conjugate() * state.q_WB).z();
    if ((pitch > 0.0) != (before > 0.0)) {
      last = t + dt * before / (before - pitch);
      if (crossings == 0) first = last;
      ++crossings;
    }
    before = pitch;
  }
  ASSERT_GE(crossings, 50);
  const double measured = M_PI * (crossings - 1) / (last - first);
  EXPECT_NEAR(measured / expected, 1.0, 1e-4);  // measured 4e-5, of which 2.5e-5 is due to the amplitude
}

}  // namespace
}  // namespace polhode
