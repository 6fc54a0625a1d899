#include "scenario/drive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "polhode/rotation_math.h"

namespace polhode::demos {
namespace {

TEST(Drive, AddsTheMotorsThatRunAtTheTime) {
  Drive drive;
  drive.motor_torques = {{Vector3(1, 0, 0), 0.0, 2.0}, {Vector3(0, 1, 0), 1.0, 3.0}};
  EXPECT_EQ(drive.motor_torque_B(0.0), Vector3(1, 0, 0));
  EXPECT_EQ(drive.motor_torque_B(1.5), Vector3(1, 1, 0));
  EXPECT_EQ(drive.motor_torque_B(2.0), Vector3(0, 1, 0)) << "until is the first moment without";
  EXPECT_EQ(drive.motor_torque_B(3.0), Vector3(0, 0, 0));
}

TEST(Drive, HasRotorsWhereAnythingTurnsOne) {
  EXPECT_FALSE(Drive().has_rotors());
  Drive with_momentum, with_motor, with_damper, with_spring;
  with_momentum.rotor_momentum_B = {0, 0, 1};
  with_motor.motor_torques = {{Vector3(1, 0, 0), 0.0, 2.0}};
  with_damper.law = InternalDamping{1.0, 1.0};
  with_spring.law = OrientationSpring{Quaternion::Identity(), 1.0};
  EXPECT_TRUE(with_momentum.has_rotors());
  EXPECT_TRUE(with_momentum.is_torque_free());
  EXPECT_TRUE(with_motor.has_rotors());
  EXPECT_FALSE(with_motor.is_torque_free());
  EXPECT_TRUE(with_damper.has_rotors());
  EXPECT_FALSE(with_spring.has_rotors());
  EXPECT_FALSE(with_spring.is_torque_free());
}

// The torque is minus the derivative of the potential along each turn.
TEST(PotentialEnergy, BelongsToTheTorqueOfItsLaw) {
  const Placement body{Quaternion(0.5, -0.1, 0.7, 0.3).normalized(), {3, -2, 1}, {1, 2, 3}, 2.0};
  constexpr double kTurn = 1e-5;
  for (const ChosenLaw& law :
       {ChosenLaw(GravityGradient{70.0, {0.5, 0, 0}}), ChosenLaw(MagneticDipole{{1, 2, 3}, {-1, 0.5, 2}}),
        ChosenLaw(OrientationSpring{Quaternion(1, 2, 3, 4).normalized(), 5.0})}) {
    const Torque torque = torque_law(law)(
        {0.0, body.q_WB, Vector3::Zero(), body.position_W, Vector3::Zero(), body.inertia_B, Vector3::Zero()});
    const Vector3 torque_W = torque.world_W + body.q_WB * torque.body_B;
    for (int axis = 0; axis < 3; ++axis) {
      const auto potential_after = [&](double angle) {
        Placement turned = body;
        turned.q_WB = exponential(angle * Vector3::Unit(axis)) * body.q_WB;
        return potential_J(law, turned);
      };
      const double slope = (potential_after(kTurn) - potential_after(-kTurn)) / (2.0 * kTurn);
      EXPECT_NEAR(torque_W[axis], -slope, 1e-7) << law.index() << " " << axis;
    }
  }
}

TEST(GravityGradient, PullsAsItsPotentialSays) {
  const GravityGradient planet{70.0, {0.5, 0, 0}};
  const Vector3 position_W(3, -2, 1);
  const Vector3 r_W = position_W - planet.centre_W;
  EXPECT_LE((planet.acceleration_W(position_W) + 70.0 / r_W.squaredNorm() * r_W.normalized()).norm(), 1e-14);
  const Placement point{Quaternion::Identity(), position_W, Vector3::Zero(), 2.0};
  EXPECT_NEAR(potential_J(planet, point), -2.0 * 70.0 / r_W.norm(), 1e-13);
}

}  // namespace
}  // namespace polhode::demos
