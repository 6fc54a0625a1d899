#include "math/mean_angular_velocity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "math/rotation.h"
#include "support/free_motion_reference.h"
#include "support/random_body.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::same_bits;

constexpr double kDt = 1.0 / 60.0;
constexpr double kTurn = 6.28318530717958647692;

struct Case {
  Quaternion start_q_WB = Quaternion::Identity();
  Quaternion end_q_WB = Quaternion::Identity();
  Vector3 near_omega_W = Vector3::Zero();
  double dt = kDt;
};

std::array<Vector3, kLanes> found_each(const std::array<Case, kLanes>& cases) {
  QuaternionWide start_q_WB;
  QuaternionWide end_q_WB;
  Vector3Wide near_omega_W;
  Wide dt;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    for (int i = 0; i < 4; ++i) start_q_WB.coeffs()[i].set(lane, cases[lane].start_q_WB.coeffs()[i]);
    for (int i = 0; i < 4; ++i) end_q_WB.coeffs()[i].set(lane, cases[lane].end_q_WB.coeffs()[i]);
    for (int i = 0; i < 3; ++i) near_omega_W[i].set(lane, cases[lane].near_omega_W[i]);
    dt.set(lane, cases[lane].dt);
  }
  Vector3Wide result;
  mean_angular_velocities_W(start_q_WB, end_q_WB, near_omega_W, dt, result);
  std::array<Vector3, kLanes> omega_W;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    omega_W[lane] = {result[0][lane], result[1][lane], result[2][lane]};
  }
  return omega_W;
}

Vector3 found(const Case& one) {
  std::array<Case, kLanes> cases;
  cases.fill(one);
  return found_each(cases)[3];
}

// A turn by omega_W for dt, and a nearby velocity as the hint.
Case turn_at(const Vector3& omega_W, double dt, const Quaternion& start_q_WB, const Vector3& offset_W) {
  const Quaternion turn_W = exponential(dt * omega_W);
  return {start_q_WB, turn_W * start_q_WB, omega_W + offset_W, dt};
}

TEST(MeanAngularVelocity, IsTheVelocityOfTheTurnThatIsNearest) {
  RandomBody random(51);
  for (int i = 0; i < 20000; ++i) {
    const double turn = std::pow(10.0, -8.0 + 12.0 * i / 20000.0);  // rad, up to 1e4
    const double dt = i % 3 == 0 ? -0.02 : kDt;
    const Vector3 omega_W = turn / dt * random.omega_W().normalized();
    // Up to 2 rad from the true turn. Near whole turns the axis would be uncertain.
    if (std::abs(std::sin(0.5 * turn)) < 1e-2 && turn > 1.0) continue;
    const Vector3 offset_W = 1.9 / std::abs(dt) * (i % 20 / 20.0) * random.omega_W().normalized();
    const Case one = turn_at(omega_W, dt, random.q_WB(), turn > 2.0 ? offset_W : Vector3(0.5 * offset_W));
    const double rounding = turn > 1.0 ? 1e-15 / std::abs(std::sin(0.5 * turn)) : 1e-15;
    EXPECT_LE((found(one) - omega_W).norm() * std::abs(dt), rounding * (1.0 + turn) + 1e-15) << turn;
  }
}

TEST(MeanAngularVelocity, At200RadPerSecondIs200) {
  const Vector3 omega_W(0, 0, 200);
  EXPECT_NEAR(found(turn_at(omega_W, kDt, Quaternion(0.5, 0.5, -0.5, 0.5), {1, 2, -3})).z(), 200.0, 1e-12);
  EXPECT_NEAR(found({Quaternion::Identity(), exponential(kDt * omega_W), Vector3::Zero(), kDt}).z(),
              200.0 - kTurn / kDt, 1e-12);
  EXPECT_NEAR(found(turn_at(omega_W, -kDt, Quaternion::Identity(), {1, 2, -3})).z(), 200.0, 1e-12);
}

// The orientations are equal, or differ only by rounding: the axis cannot be computed from them.
TEST(MeanAngularVelocity, OfWholeTurnsHasTheAxisOfTheNearVelocity) {
  RandomBody random(52);
  for (const double turns : {1.0, 2.0, -1.0, 40.0}) {
    const Vector3 axis_W = random.omega_W().normalized();
    const Vector3 omega_W = turns * kTurn / kDt * axis_W;
    const Quaternion q_WB = random.q_WB();
    for (const double near : {0.95, 1.0, 1.01}) {
      const Vector3 same = found({q_WB, q_WB, near * omega_W, kDt});
      if (std::abs(turns * (near - 1.0)) > 0.4) continue;
      EXPECT_LE((same - omega_W).norm() * kDt, 1e-14 * std::abs(turns)) << turns;
    }
    const Vector3 rounded = found(turn_at(omega_W, kDt, q_WB, Vector3::Zero()));
    EXPECT_LE((rounded - omega_W).norm() * kDt, 4e-15 * (4.0 + kTurn * std::abs(turns))) << turns;
  }
}

TEST(MeanAngularVelocity, OverNoTimeIsTheNearOne) {
  const Case one{Quaternion::Identity(), Quaternion::Identity(), {1, 2, 3}, 0.0};
  EXPECT_EQ(found(one), one.near_omega_W);
}

TEST(MeanAngularVelocity, AtRestIsZero) {
  const Quaternion q_WB = RandomBody(53).q_WB();
  // measured 0
  EXPECT_LE(found({q_WB, q_WB, Vector3::Zero(), kDt}).norm() * kDt, 1e-16);
}

// On both sides of the limit between the series and the general formula.
TEST(MeanAngularVelocity, IsContinuousWhereTheSeriesEnds) {
  for (const double turn : {0.4510, 0.45102, 0.4511}) {
    const Vector3 omega_W(0, turn / kDt, 0);
    EXPECT_NEAR(found(turn_at(omega_W, kDt, Quaternion::Identity(), Vector3::Zero())).y() * kDt, turn, 2e-16);
  }
}

TEST(MeanAngularVelocity, InALaneDoesNotDependOnTheOthers) {
  RandomBody random(54);
  for (int i = 0; i < 2000; ++i) {
    std::array<Case, kLanes> cases;
    for (Case& one : cases) one = turn_at(random.omega_W(), 0.05, random.q_WB(), random.omega_W());
    if (i % 3 == 0) cases[2].end_q_WB.coeffs().setConstant(std::nan(""));
    if (i % 3 == 1) cases[5].dt = 0.0;
    const std::array<Vector3, kLanes> together = found_each(cases);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      EXPECT_TRUE(same_bits(together[lane], found(cases[lane]))) << lane;
    }
  }
}

}  // namespace
}  // namespace polhode
