#include "oracle/symmetric_top.h"

#include <gtest/gtest.h>

#include "support/free_motion_reference.h"

namespace polhode::oracle {
namespace {

TEST(SymmetricTop, MovesAsFineStepsDo) {
  const double transverse = 1.5;
  for (const double axial : {0.5, 1.5, 2.5}) {
    RotationState start;
    start.q_WB = Quaternion(0.3, -0.4, 0.5, 0.7).normalized();
    start.L_W = {1, -2, 3};
    const RotationState exact = SymmetricTop(transverse, axial, start.q_WB, start.L_W).at(1.0);
    const RotationState fine =
        polhode::testing::integrate_finely({transverse, transverse, axial}, start, 1.0, 5000);
    EXPECT_LT(polhode::testing::angle_between(exact.q_WB, fine.q_WB), 1e-13) << axial;  // measured 3.1e-14
    EXPECT_LT((exact.omega_W - fine.omega_W).norm(), 1e-13) << axial;                   // measured 2.7e-14
  }
}

TEST(SymmetricTop, StaysAtRest) {
  const SymmetricTop top(1, 2, Quaternion(0, 1, 0, 0), Vector3::Zero());
  EXPECT_EQ(top.at(10.0).q_WB.coeffs(), Quaternion(0, 1, 0, 0).coeffs());
}

}  // namespace
}  // namespace polhode::oracle
