#include "scenario/start_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace polhode::demos {
namespace {

TEST(StartMotion, TurnsTheTwoForcesOfTheHandoutIntoItsMomentum) {
  Body body;
  body.impulses = {{{10, 0, 0}, {1, 1, 1}}, {{-10, 0, 0}, {-1, -1, -1}}};
  const Vector3 inertia_B = Vector3::Constant(2.0 / 3.0);
  const StartMotion motion = start_motion(body, inertia_B);
  const Vector3 L_W = inertia_B.cwiseProduct(motion.omega_W);
  EXPECT_LT((L_W - Vector3(0, 20, -20)).norm(), 1e-14);  // measured 0
  EXPECT_EQ(motion.velocity_W, Vector3(0, 0, 0));
}

TEST(StartMotion, AddsImpulsesToTheVelocitiesOfTheFile) {
  Body body;
  body.mass = 2.0;
  body.velocity_W = {1, 0, 0};
  body.omega_W = {0, 0, 1};
  body.impulses = {{{0, 4, 0}, {3, 0, 0}}};
  const StartMotion motion = start_motion(body, {1, 1, 6});
  EXPECT_EQ(motion.velocity_W, Vector3(1, 2, 0));
  EXPECT_EQ(motion.omega_W, Vector3(0, 0, 3));
}

TEST(StartMotion, UsesTheInertiaInTheWorldsAxes) {
  Body body;
  body.q_WB = Quaternion(std::sqrt(0.5), 0, 0, std::sqrt(0.5));  // the body's y axis along -x of the world
  body.impulses = {{{0, 0, 1}, {0, 1, 0}}};
  const StartMotion motion = start_motion(body, {1, 4, 9});
  EXPECT_LT((motion.omega_W - Vector3(0.25, 0, 0)).norm(), 1e-15);  // measured 2.0e-16
}

TEST(StartMotion, RefusesASpeedNobodyMayAskFor) {
  Body body;
  body.impulses = {{{1e9, 0, 0}, {0, 1e6, 0}}};
  EXPECT_THAT(
      [&] {
        start_motion(body, {1e-9, 1e-9, 1e-9});
      },
      testing::ThrowsMessage<std::invalid_argument>(
          testing::AllOf(testing::HasSubstr("\"impulses\""), testing::HasSubstr("valid is at most 1e+09"))));
}

}  // namespace
}  // namespace polhode::demos
