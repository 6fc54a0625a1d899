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
  EXPECT_EQ(order, FreeTopStep<double>::kOrders);
}

TEST(FreeTopStep, StoresTheNumberOfSubstepsWithTheAxisOrder) {
  for (double order = 0.0; order < FreeTopStep<double>::kOrders; order += 1.0) {
    FreeTopStep<double> step{};
    step.kind = order;
    EXPECT_TRUE(is_short(step));
    EXPECT_EQ(substeps_of(step), 1);
    for (const int substeps : {0, 1, 2, 300}) {
      set_substeps(step, substeps);
      EXPECT_FALSE(is_short(step));
      EXPECT_EQ(substeps_of(step), substeps);
      EXPECT_EQ(axes_of(step), axes_of(order));
    }
  }
}

/// A single short step of a motion.
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
    Vector3Wide inertia_B, u_B;
    Wide length_times_h;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Vector3 I_B = random.inertia_B();
      const Vector3 v_B = random.omega_W().normalized();
      const double turn_times_moment = 0.0115 * (block + 1) * I_B.minCoeff();
      for (int i = 0; i < 3; ++i) inertia_B[i].set(lane, I_B[i]);
      for (int i = 0; i < 3; ++i) u_B[i].set(lane, v_B[i]);
      length_times_h.set(lane, turn_times_moment);
      alone.emplace_back(I_B, v_B, turn_times_moment);
    }
    const Made<Wide> together(inertia_B, u_B, length_times_h);
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

// Above 1e15 rad, rounding determines the number of whole periods; the remainder would otherwise take hours
// of substeps.
TEST(FreeTopStep, TakesFewSubstepsHoweverLongItIs) {
  for (const Vector3& inertia_B : {Vector3(1, 2, 3), Vector3(1e-6, 1, 1e6), Vector3(1, 1, 2)}) {
    for (const Vector3& direction_B : {Vector3(1, 2, 3), Vector3(1e-9, 1, 1e-9), Vector3(0, 1, 0)}) {
      for (double length = 1.0; length < 1e60; length *= 7.0) {
        const FreeTopStep<double> step = make_free_top_step(inertia_B, direction_B * length, 1.0);
        EXPECT_LE(substeps_of(step), 400) << length;  // measured at most 220
      }
    }
  }
}

}  // namespace
}  // namespace polhode::free_top
