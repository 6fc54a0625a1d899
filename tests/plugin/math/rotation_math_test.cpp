#include "polhode/rotation_math.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/rotation.h"
#include "polhode/scheme_registry.h"
#include "support/free_motion_reference.h"
#include "support/random_body.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::RandomBody;
using testing::same_bits;

constexpr double kEpsilon = 2.3e-16;

TEST(RotationMath, SkewIsTheCrossProduct) {
  const Vector3 a(1.0, -2.0, 3.0);
  const Vector3 b(0.5, 4.0, -1.0);
  EXPECT_EQ(skew(a) * b, a.cross(b));
}

TEST(RotationMath, ExponentialIsAxisAndAngleOnBothSidesOfItsSeries) {
  const Vector3 axis = Vector3(1.0, -2.0, 0.5).normalized();
  for (const double angle : {1e-300, 1e-12, 1e-6, 0.99e-3, 0.9999e-3, 1.0001e-3, 1e-2, 1.0, 3.0, 6.0, 50.0}) {
    const Quaternion q = exponential(angle * axis);
    // The angle |v| itself is rounded. Measured 6.3e-17 relative up to 1 rad, 3.6e-15 at 50 rad.
    EXPECT_NEAR(q.w(), std::cos(0.5 * angle), kEpsilon * (1.0 + angle)) << angle;
    EXPECT_LE((q.vec() - std::sin(0.5 * angle) * axis).norm(), kEpsilon * (angle + std::min(1.0, angle)))
        << angle;
  }
  EXPECT_EQ(exponential(Vector3::Zero()).coeffs(), Quaternion::Identity().coeffs());
}

// Compares with extended precision where available.
TEST(RotationMath, ExponentialOfLargeTurnsIsAccurate) {
  RandomBody random(3);
  for (double angle = 1.0; angle <= 1e6; angle *= 1.01) {
    const Vector3 v = angle * random.omega_W().normalized();
    const Eigen::Matrix<long double, 3, 1> exact_v = v.cast<long double>();
    const long double exact_angle = exact_v.norm();
    const Eigen::Matrix<long double, 3, 1> vector = std::sin(exact_angle / 2) / exact_angle * exact_v;
    const Quaternion q = exponential(v);
    // The angle is rounded. Measured 1.9e-16 (2 + angle/2).
    const double tolerance = kEpsilon * (2.0 + 0.5 * angle);
    EXPECT_NEAR(q.w(), static_cast<double>(std::cos(exact_angle / 2)), tolerance) << angle;
    EXPECT_LE((q.vec().cast<long double>() - vector).norm(), tolerance) << angle;
    EXPECT_NEAR(q.norm(), 1.0, 1e-15);
  }
}

TEST(RotationMath, ExponentialAndLogarithmOfEightAreThoseOfEach) {
  RandomBody random(5);
  for (int i = 0; i < 2000; ++i) {
    Vector3Wide v;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Vector3 turn = std::pow(10.0, -5.0 + 0.005 * i) * random.omega_W();
      for (int k = 0; k < 3; ++k) v[k].set(lane, turn[k]);
    }
    const QuaternionWide q = formulas::exponential(v);
    const Vector3Wide shortest = formulas::logarithm(q);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Quaternion alone = exponential(Vector3(v[0][lane], v[1][lane], v[2][lane]));
      for (int k = 0; k < 4; ++k) ASSERT_TRUE(same_bits(q.coeffs()[k][lane], alone.coeffs()[k]));
      for (int k = 0; k < 3; ++k) ASSERT_TRUE(same_bits(shortest[k][lane], logarithm(alone)[k]));
    }
  }
}

TEST(RotationMath, LogarithmUndoesTheExponential) {
  const Vector3 axis = Vector3(-3.0, 1.0, 2.0).normalized();
  for (const double angle : {0.0, 1e-12, 0.9999e-3, 1.0001e-3, 0.5, 2.0, 3.14}) {
    // measured 0
    EXPECT_LE((logarithm(exponential(angle * axis)) - angle * axis).norm(), 2e-15) << angle;
  }
  // Takes the shorter way for both q and -q; measured 8.9e-16.
  EXPECT_NEAR(logarithm(exponential(4.0 * axis)).norm(), 2.0 * M_PI - 4.0, 2e-15);
}

TEST(RotationMath, AngularMomentumUndoesInverseInertiaForAnyBasis) {
  RandomBody random(1);
  for (int i = 0; i < 100; ++i) {
    const Vector3 inertia_B = random.inertia_B();
    const Vector3 omega_W = random.omega_W();
    Matrix3 R_WB = random.q_WB().toRotationMatrix();
    R_WB.col(1) *= 1.5;  // swollen
    R_WB.col(2) += 0.2 * R_WB.col(0);
    const Vector3 L_W = angular_momentum_W(R_WB, inertia_B, omega_W);
    // The condition number of the inertia, up to 1e4, amplifies rounding; measured 2.7e-13.
    EXPECT_LE((inverse_inertia_W(R_WB, inertia_B) * L_W - omega_W).norm(), 1e-12 * omega_W.norm());
  }
}

TEST(RotationMath, BulletTurnsByTheFullAngleBelowItsCutAndLessBeyond) {
  const double dt = 0.01;
  const Vector3 axis = Vector3(0.0, 0.6, 0.8);
  const double cut = kBulletTurnLimit / dt;
  const auto turn = [&](double speed) {
    return testing::angle_between(Quaternion::Identity(),
                                  turn_like_bullet(Quaternion::Identity(), speed * axis, dt));
  };
  // measured 2.2e-16
  EXPECT_NEAR(turn(0.5 * cut), 0.5 * kBulletTurnLimit, 1e-15);
  EXPECT_NEAR(turn(cut), kBulletTurnLimit, 1e-15);
  EXPECT_NEAR(turn(3.0 * cut), 2.0 * std::atan(3.0 * std::tan(M_PI / 8.0)), 1e-15);
  EXPECT_EQ(turn(0.0), 0.0);
}

TEST(RotationMath, EulerTurnsByTwiceTheArcTangent) {
  const Quaternion q = turn_by_euler(Quaternion::Identity(), Vector3(0.0, 0.0, 200.0), 1.0 / 60.0);
  // measured 0
  EXPECT_NEAR(testing::angle_between(Quaternion::Identity(), q), 2.0 * std::atan(100.0 / 60.0), 1e-15);
}

TEST(RotationMath, ImplicitChangeIsThatOfTheScheme) {
  RandomBody random(4);
  for (int i = 0; i < 100; ++i) {
    const Vector3 inertia_B = Vector3(1, 2, 3) + 0.01 * random.inertia_B();
    const RotationState start =
        testing::state_from(inertia_B, random.q_WB(), 30.0 * random.omega_W().normalized());
    for (const char* scheme : {"implicit_gyroscopic", "bullet"}) {
      RotationState state = start;
      find_scheme(scheme)->step({inertia_B, Vector3::Zero(), 0.02}, state);
      const Vector3 change_W = implicit_gyroscopic_change_W(start, inertia_B, 0.02);
      // measured 2.7e-16
      EXPECT_LE((state.omega_W - start.omega_W - change_W).norm(), 1e-15 * start.omega_W.norm()) << scheme;
    }
  }
}

TEST(RotationMath, ImplicitChangeSolvesItsNewtonEquation) {
  // In extended precision where available: a cross product of nearly parallel vectors rounds by more than the
  // tolerance.
  using Vector = Eigen::Matrix<long double, 3, 1>;
  RandomBody random(2);
  for (int i = 0; i < 200000; ++i) {
    const Vector3 inertia_B = random.inertia_B();
    const Vector3 omega_B = random.omega_W();
    const long double dt = 0.02;
    const Vector change = implicit_gyroscopic_change_B(inertia_B, omega_B, 0.02).cast<long double>();
    // f(omega + change) to first order in change: I change + dt (omega x I change + change x I omega) = -dt
    // omega x I omega.
    const Vector omega = omega_B.cast<long double>();
    const Vector L = inertia_B.cast<long double>().cwiseProduct(omega);
    const Vector L_change = inertia_B.cast<long double>().cwiseProduct(change);
    const Vector left = L_change + dt * (omega.cross(L_change) + change.cross(L));
    const Vector right = -dt * omega.cross(L);
    // measured 5.5e-16 relative to the terms; 4e-15 with Cramer's rule alone
    const long double size =
        L_change.norm() + dt * (omega.norm() * L_change.norm() + change.norm() * L.norm());
    EXPECT_LE((left - right).norm(), 2e-15L * size);
  }
}

}  // namespace
}  // namespace polhode
