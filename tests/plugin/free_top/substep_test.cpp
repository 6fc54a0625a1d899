#include "free_top/substep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "free_top/free_top_step.h"
#include "support/random_body.h"

namespace polhode::free_top {
namespace {

constexpr double kUlp = 2.2e-16;

TEST(SineCosine, AgreeWithTheStandardLibrarysUpToAnUlpOfOne) {
  double worst = 0.0;
  for (double x = -1.25; x <= 1.25; x += 1e-4) {
    const auto [sine, cosine] = sine_cosine(x);
    worst = std::max({worst, std::abs(sine - std::sin(x)), std::abs(cosine - std::cos(x))});
  }
  EXPECT_LE(worst, 1.5 * kUlp);  // measured 2.2e-16
  EXPECT_EQ(sine_cosine(0.0).sine, 0.0);
  EXPECT_EQ(sine_cosine(0.0).cosine, 1.0);
}

TEST(Labels, OrderTheAxesRoundWhichThePolhodeCloses) {
  for (const Vector3& inertia_B : {Vector3(1, 2, 3), Vector3(1, 3, 2), Vector3(2, 1, 3), Vector3(2, 3, 1),
                                   Vector3(3, 1, 2), Vector3(3, 2, 1)}) {
    for (const double greatest : {1.0, 3.0}) {
      Eigen::Index axis = 0;
      (inertia_B.array() - greatest).abs().minCoeff(&axis);
      const Vector3 u_B = (Vector3(0.1, 0.2, 0.15) + Vector3::Unit(axis)).normalized();
      const auto body = labelled<double>(inertia_B, u_B);
      EXPECT_EQ(body.inertia, (Triple<double>{4.0 - greatest, 2.0, greatest}));
      EXPECT_EQ(body.inertia, in_order(body.axes, inertia_B));
      EXPECT_EQ(body.u, in_order(body.axes, u_B));
      EXPECT_EQ(in_body(body.axes, body.u), u_B);
      Matrix3 permutation;
      for (int i = 0; i < 3; ++i) {
        permutation.row(i) = Vector3::Unit(static_cast<Eigen::Index>(body.axes[static_cast<std::size_t>(i)]));
      }
      EXPECT_EQ(body.parity, permutation.determinant());
    }
  }
}

TEST(Labels, PutTheAxesIntoOneNumber) {
  std::array<double, 3> axes = {0.0, 1.0, 2.0};
  double order = 0.0;
  do {
    EXPECT_EQ(order_of<double>(axes), order);
    EXPECT_EQ(axes_of(order), axes);
    order += 1.0;
  } while (std::next_permutation(axes.begin(), axes.end()));
  EXPECT_EQ(order, FreeTopStep::kOrders);
}

TEST(FreeTopStep, KeepsTheNumberOfItsSubstepsBesideTheOrderOfItsAxes) {
  for (double order = 0.0; order < FreeTopStep::kOrders; order += 1.0) {
    FreeTopStep step{};
    step.kind = order;
    EXPECT_TRUE(step.is_short());
    EXPECT_EQ(step.substeps(), 1);
    for (const int substeps : {0, 1, 2, 300}) {
      step.set_substeps(substeps);
      EXPECT_FALSE(step.is_short());
      EXPECT_EQ(step.substeps(), substeps);
      EXPECT_EQ(step.axes(), axes_of(order));
    }
  }
}

/// A short step of one motion.
template <class Real>
struct Made {
  Substep<Real> substep;
  Triple<Real> next;
  Eigen::Quaternion<Real, Eigen::DontAlign> turn;

  Made(const Eigen::Matrix<Real, 3, 1>& inertia_B, const Eigen::Matrix<Real, 3, 1>& u_B,
       const Real& length_times_h) {
    const auto body = labelled<Real>(inertia_B, u_B);
    const Motion<Real> motion = motion_of(body.inertia, body.u, length_times_h);
    substep = make_substep(motion, body.parity, Real(1.0), Real(0.0));
    next = moved(substep, body.u);
    turn = turn_of(substep, body.axes, body.u, next);
  }
};

TEST(Substep, OfEightBodiesIsThatOfEachToTheLastBit) {
  testing::RandomBody random(31);
  for (int block = 0; block < 100; ++block) {
    std::vector<Made<double>> alone;
    Vector3L inertia_B, u_B;
    Lanes length_times_h;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Vector3 I_B = random.inertia_B();
      const Vector3 v_B = random.omega_W().normalized();
      const double turn_times_moment = 0.0115 * (block + 1) * I_B.minCoeff();
      for (int i = 0; i < 3; ++i) inertia_B[i].set(lane, I_B[i]);
      for (int i = 0; i < 3; ++i) u_B[i].set(lane, v_B[i]);
      length_times_h.set(lane, turn_times_moment);
      alone.emplace_back(I_B, v_B, turn_times_moment);
    }
    const Made<Lanes> together(inertia_B, u_B, length_times_h);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(together.substep.mu[i][lane], alone[lane].substep.mu[i]);
        EXPECT_EQ(together.substep.slope[i][lane], alone[lane].substep.slope[i]);
        EXPECT_EQ(together.next[i][lane], alone[lane].next[i]);
      }
      for (int i = 0; i < 4; ++i) EXPECT_EQ(together.turn.coeffs()[i][lane], alone[lane].turn.coeffs()[i]);
    }
  }
}

}  // namespace
}  // namespace polhode::free_top
