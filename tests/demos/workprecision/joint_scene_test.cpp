// Errors and energies of scenes that are disturbed by a known amount, and Bullet's plain integration of each
// scene, which does not involve the library.
#include "workprecision/joints/joint_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "polhode/rotation_math.h"
#include "workprecision/joints/joint_motion.h"
#include "workprecision/joints/joints_grid.h"
#include "workprecision/joints/joints_verdict.h"
#include "world/body_rotation.h"

namespace polhode::demos {
namespace {

constexpr double kDt = 1.0 / 60.0;
constexpr bool kDouble = sizeof(btScalar) == sizeof(double);
// Poses are read back from Bullet: measured 2e-16 and 9e-8 rad.
constexpr double kReading = kDouble ? 1e-14 : 2e-6;

std::unique_ptr<JointScene> scene(JointKind kind, double omega_dt, double ratio = 4.0, double tilt = 0.5,
                                  const std::string& contender = "bullet:none") {
  return make_joint_scene(kind, find_contenders({contender}).front(), {omega_dt, ratio, tilt, kDt});
}

JointMotion motion(JointKind kind, double omega_dt, double ratio = 4.0, double tilt = 0.5) {
  return follow(*scene(kind, omega_dt, ratio, tilt), kDt, 300);
}

void turn(btRigidBody& body, const Vector3& angle_W) {
  const Quaternion q_WB = exponential(angle_W) * rotation_of(body).q_WB;
  body.setCenterOfMassTransform(btTransform(to_bullet(q_WB), body.getCenterOfMassPosition()));
}

// Returns an axis perpendicular to the axis of spin.
Vector3 aside(const btRigidBody& body) {
  return from_bullet(body.getAngularVelocity()).unitOrthogonal();
}

TEST(JointScene, MeasuresHowFarAHingeIsOffItsAxis) {
  const auto hinge = scene(JointKind::hinge, 0.1);
  EXPECT_NEAR(hinge->joint_error(), 0.0, kReading);
  const Vector3 axis_W = from_bullet(hinge->body().getAngularVelocity()).normalized();
  turn(hinge->body(), 0.7 * axis_W);
  EXPECT_NEAR(hinge->joint_error(), 0.0, kReading) << "that it may";
  turn(hinge->body(), 0.3 * aside(hinge->body()));
  EXPECT_NEAR(hinge->joint_error(), 0.3, kReading);
}

TEST(JointScene, MeasuresHowFarAWeldGives) {
  const auto weld = scene(JointKind::weld, 0.1);
  EXPECT_NEAR(weld->joint_error(), 0.0, kReading);
  turn(weld->body(0), {0.4, 0.0, 0.0});
  turn(weld->body(1), {0.4, 0.0, 0.0});
  EXPECT_NEAR(weld->joint_error(), 0.0, kReading) << "both the same";
  turn(weld->body(1), {0.0, 0.2, 0.0});
  EXPECT_NEAR(weld->joint_error(), 0.2, kReading);
}

TEST(JointScene, MeasuresThePointsGapByTheArm) {
  const auto point = scene(JointKind::point, 0.1);
  EXPECT_NEAR(point->joint_error(), 0.0, kReading);
  point->body().translate(btVector3(0, btScalar(0.03), 0));
  EXPECT_NEAR(point->joint_error(), 0.1, kReading) << "the arm is 0.3 m";
}

TEST(JointScene, SumsTheTurnAboutALockedAxis) {
  const auto lock = scene(JointKind::lock, 0.1);
  for (int step = 1; step <= 3; ++step) {
    lock->body().setAngularVelocity(btVector3(btScalar(0.5), 0, btScalar(1.2)));
    lock->step();
    EXPECT_NEAR(lock->joint_error(), step * 1.2 * kDt, kReading) << "0.02 rad in each step";
  }
}

TEST(JointScene, MeasuresASpringsSwingBeyondItsStart) {
  const auto spring = scene(JointKind::spring, 0.1);
  turn(spring->body(), {0.0, 0.0, 0.09});
  EXPECT_EQ(spring->joint_error(), 0.0);
  turn(spring->body(), {0.0, 0.0, 0.06});
  EXPECT_NEAR(spring->joint_error(), 0.05, kReading);
  // k = I_1 (2 sin(0.05)/dt)^2.
  const double stiffness = 0.1 * std::pow(2.0 * std::sin(0.05) / kDt, 2);
  spring->body().setAngularVelocity(btVector3(0, 0, 0));
  EXPECT_NEAR(spring->energy_J(), 0.5 * stiffness * 0.15 * 0.15, 10 * kReading);
}

TEST(JointScene, CountsTheEnergyOfAllMotion) {
  const double speed = 0.3 / kDt;
  // At ratio 1 every moment is 0.1 kg m^2, that of the second welded body 0.2. Arms of 0.25 and 0.3 m have
  // the cosine 8/9 with the axis of spin.
  const double across = 1.0 - 64.0 / 81.0;
  // Measured 2e-16 and 2e-8 of the energy.
  const double relative = kDouble ? 1e-14 : 1e-6;
  const double hinge_J = 0.5 * 0.1 * speed * speed;
  EXPECT_NEAR(scene(JointKind::hinge, 0.3, 1.0)->energy_J(), hinge_J, relative * hinge_J);
  const double weld_J = 0.5 * (0.1 + 0.2 + 2 * 0.0625 * across) * speed * speed;
  EXPECT_NEAR(scene(JointKind::weld, 0.3, 1.0)->energy_J(), weld_J, relative * weld_J);
  const double point_J = 0.5 * (0.1 + 0.09 * across) * speed * speed;
  EXPECT_NEAR(scene(JointKind::point, 0.3, 1.0)->energy_J(), point_J, relative * point_J);
}

TEST(JointScene, DivergesWhenItIsNotFiniteOrAHundredTimesTooFast) {
  for (const JointKind kind : kJointKinds) {
    const auto sound = scene(kind, 0.1);
    sound->body().setAngularVelocity(sound->body().getAngularVelocity() * btScalar(50));
    EXPECT_FALSE(sound->diverged()) << to_string(kind);
    sound->body().setAngularVelocity(btVector3(0, 0, btScalar(1e5)));
    EXPECT_TRUE(sound->diverged()) << to_string(kind);
    sound->body().setAngularVelocity(btVector3(0, 0, std::numeric_limits<btScalar>::quiet_NaN()));
    EXPECT_TRUE(sound->diverged()) << to_string(kind);
  }
}

TEST(JointScene, DivergesWhenTheLibrarySaysSo) {
  const auto hinge = scene(JointKind::hinge, 0.1, 4.0, 0.5, "rk4");
  hinge->step();
  EXPECT_FALSE(hinge->diverged());
  hinge->body().applyTorque(btVector3(std::numeric_limits<btScalar>::infinity(), 0, 0));
  hinge->step();
  EXPECT_TRUE(hinge->diverged());
}

TEST(JointScene, IsHeldByBulletWithoutAGyroscopicTerm) {
  for (const double omega_dt : {0.02, 0.3, 1.5}) {
    // Hinge, motor and lock turn about a fixed axis, without the gyroscopic term: measured 6e-15 and 2e-6
    // rad.
    const double tolerance = kDouble ? 1e-13 : 1e-5;
    for (const JointKind kind : {JointKind::hinge, JointKind::lock}) {
      const JointMotion held = motion(kind, omega_dt, 1.0);
      EXPECT_LT(held.worst_joint_error, tolerance) << to_string(kind) << omega_dt;
      EXPECT_NEAR(held.worst_energy_gain, 1.0, tolerance) << to_string(kind) << omega_dt;
    }
    EXPECT_LT(motion(JointKind::motor, omega_dt, 1.0).worst_speed_error, tolerance) << omega_dt;
  }
  // Measured 2e-15 and 9e-7 rad; a point 0.013 in either precision.
  EXPECT_LT(motion(JointKind::weld, 0.1).worst_joint_error, kDouble ? 1e-12 : 1e-5);
  EXPECT_LT(motion(JointKind::point, 0.1).worst_joint_error, 0.02);
}

TEST(JointScene, SwingsAsSymplecticEulerDoes) {
  for (const double omega_dt : {0.1, 0.5, 2.9}) {
    // A single axis: omega' = omega - (k/I) dt angle, angle' = angle + dt omega'.
    const double k_by_I = std::pow(2.0 * std::sin(omega_dt / 2.0) / kDt, 2);
    double omega = 0.1 * std::sin(omega_dt) / kDt;
    const double start = omega * omega;
    double angle = 0.0;
    double gain = 0.0;
    for (int step = 1; step <= 300; ++step) {
      omega -= k_by_I * kDt * angle;
      angle += kDt * omega;
      if (step > 60) gain = std::max(gain, (omega * omega + k_by_I * angle * angle) / start);
    }
    const JointMotion swing = motion(JointKind::spring, omega_dt, 4.0, 0.0);
    // Single precision feeds its rounding back through the spring: measured 2e-13 and 2e-4 of the gain.
    EXPECT_NEAR(swing.worst_energy_gain, gain, (kDouble ? 1e-11 : 1e-3) * gain) << omega_dt;
    EXPECT_LT(swing.worst_joint_error, kDouble ? 1e-12 : 1e-5) << "0.1 rad is all";
  }
}

TEST(JointMotionAfterAStep, SaysWhenItDiverged) {
  const auto point = scene(JointKind::point, 0.1);
  point->body().applyTorque(btVector3(0, 0, btScalar(1e30)));
  const JointMotion end = follow(*point, kDt, 300);
  EXPECT_TRUE(end.diverged);
  EXPECT_EQ(end.steps, 0);
}

TEST(JointMotionAfterAStep, MeasuresNothingInTheFirstSecond) {
  const auto hinge = scene(JointKind::hinge, 0.1);
  const JointMotion first = follow(*hinge, kDt, 60);
  EXPECT_EQ(first.worst_energy_gain, 0.0);
  EXPECT_EQ(follow(*scene(JointKind::hinge, 0.1), kDt, 61).steps, 61);
  EXPECT_GT(follow(*scene(JointKind::hinge, 0.1), kDt, 61).worst_energy_gain, 0.9);
}

// A hinge and a motor, with a scheme and Bullet's four modes.
class JointsVerdictOf : public testing::Test {
 protected:
  JointsVerdictOf() {
    grid_.kinds = {JointKind::hinge, JointKind::motor};
    grid_.omega_dt = {0.25, 1.0, 1};
    grid_.inertia_ratio.count = 1;
    grid_.tilt.count = 1;
    for (std::int64_t i = 0; i < grid_.cell_count(); ++i) results_.push_back({i, {1e-4, 1.0, 0.1}, 0});
  }

  JointsVerdict verdict() const { return joints_verdicts(grid_, results_).at(0); }
  CellResult& hinge(std::size_t contender) { return results_[2 * contender]; }
  CellResult& motor(std::size_t contender) { return results_[2 * contender + 1]; }

  static constexpr std::size_t kScheme = 0;
  static constexpr std::size_t kBulletNone = 1;
  static constexpr std::size_t kBulletDefault = 4;
  JointsGrid grid_;
  std::vector<CellResult> results_;
};

TEST_F(JointsVerdictOf, TheSameIsNotWorse) {
  EXPECT_EQ(verdict().cells, 2);
  EXPECT_EQ(verdict().cells_with_energy, 1);
  EXPECT_EQ(verdict().worse_joint_error + verdict().worse_energy_gain + verdict().worse_speed_error, 0);
  EXPECT_EQ(verdict().joint_error_excess, 0.0);
}

TEST_F(JointsVerdictOf, AllowsEachFigureItsMargin) {
  hinge(kScheme).figures = {1.09e-3, 1.019, 9.0};
  motor(kScheme).figures = {1.09e-3, 9.0, 0.109};
  EXPECT_EQ(verdict().worse_joint_error + verdict().worse_energy_gain + verdict().worse_speed_error, 0)
      << "a hinge has no speed to hold, a motor no energy";
  hinge(kScheme).figures = {1.11e-3, 1.021, 9.0};
  motor(kScheme).figures = {1.11e-3, 9.0, 0.111};
  EXPECT_EQ(verdict().worse_joint_error, 2);
  EXPECT_EQ(verdict().worse_energy_gain, 1);
  EXPECT_EQ(verdict().worse_speed_error, 1);
  hinge(kBulletDefault).figures[1] = 1.01;
  EXPECT_EQ(verdict().worse_energy_gain, 0) << "Bullet gains as much";
}

TEST_F(JointsVerdictOf, TakesACellThatDivergedForWorseInEverything) {
  hinge(kScheme) = {0, {}, 7};
  motor(kScheme) = {1, {}, 7};
  EXPECT_EQ(verdict().diverged, 2);
  EXPECT_EQ(verdict().worse_joint_error, 2);
  EXPECT_EQ(verdict().worse_energy_gain, 1);
  EXPECT_EQ(verdict().worse_speed_error, 1);
  hinge(kBulletDefault) = {8, {}, 9};
  EXPECT_EQ(verdict().bullet_diverged, 1);
  EXPECT_EQ(verdict().worse_joint_error, 1) << "the motor's";
}

TEST_F(JointsVerdictOf, HoldsTheExcessAgainstTheWorstModeOfTheSameCell) {
  hinge(kScheme).figures[0] = 0.5;
  hinge(kBulletNone).figures[0] = 0.375;
  EXPECT_EQ(verdict().joint_error_excess, 0.125);
  grid_.omega_dt.from = 0.51;
  EXPECT_EQ(verdict().joint_error_excess, 0.0) << "the step is too long to be held to it";
}

}  // namespace
}  // namespace polhode::demos
