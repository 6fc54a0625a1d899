// Tests project_onto_unlocked_axes against a direct solution of the constrained equations.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "bullet/body/locked_axes.h"
#include "polhode/rotation_math.h"
#include "support/random_body.h"

namespace polhode::testing {
namespace {

// Gauss's principle: among all velocities x without locked components, the body takes the one nearest to the
// free velocity v in the metric of its inertia. With multipliers y for the locked components, P^T x = 0:
//  [ I_W  P ] [x]   [ I_W v ]
//  [ P^T  0 ] [y] = [   0   ]
Vector3 by_multipliers(const Matrix3& inertia_W, const Vector3& angular_factor, const Vector3& free_W) {
  std::vector<int> locked;
  for (int axis = 0; axis < 3; ++axis) {
    if (angular_factor[axis] == 0.0) locked.push_back(axis);
  }
  const int rows = 3 + static_cast<int>(locked.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(rows, rows);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(rows);
  system.topLeftCorner(3, 3) = inertia_W;
  right.head(3) = inertia_W * free_W;
  for (int row = 3; row < rows; ++row) system(row, locked[row - 3]) = system(locked[row - 3], row) = 1.0;
  return system.fullPivLu().solve(right).head(3);
}

TEST(ProjectionOntoUnlockedAxes, SolvesTheConstrainedEquations) {
  RandomBody random(1);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3 inertia_B = random.inertia_B();
    const Matrix3 R_WB = random.q_WB().toRotationMatrix();
    const Vector3 free_W = random.omega_W();
    const Vector3 factor(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    const Vector3 projected_W =
        project_onto_unlocked_axes(inverse_inertia_W(R_WB, inertia_B), factor, free_W);
    const Matrix3 inertia_W = R_WB * inertia_B.asDiagonal() * R_WB.transpose();
    const Vector3 expected = by_multipliers(inertia_W, factor, free_W);
    // Relative to the free components, which can be large where the moments differ much.
    worst = std::max(worst, (projected_W - expected).norm() / std::max(free_W.norm(), expected.norm()));
    for (int axis = 0; axis < 3; ++axis) {
      if (factor[axis] != 0.0) continue;
      EXPECT_EQ(projected_W[axis], 0.0);
    }
  }
  // measured 1.4e-13
  EXPECT_LT(worst, 1e-12);
}

TEST(ProjectionOntoUnlockedAxes, LeavesAVelocityAloneWhereNothingIsLocked) {
  const Matrix3 inverse = inverse_inertia_W(Matrix3::Identity(), Vector3(1, 2, 3));
  EXPECT_EQ(project_onto_unlocked_axes(inverse, Vector3(1, 1, 1), Vector3(4, 5, 6)), Vector3(4, 5, 6));
}

TEST(ProjectionOntoUnlockedAxes, IsFiniteWhereTheBodyHasNoInverseInertiaAboutALockedAxis) {
  for (int mask = 0; mask < 8; ++mask) {
    const Vector3 factor(mask & 1, (mask >> 1) & 1, (mask >> 2) & 1);
    for (const Vector3& inverse_B :
         {Vector3(0, 0, 0), Vector3(1e-30, 0, 0), Vector3(0, 1, 1), Vector3(0, 0, 1)}) {
      EXPECT_TRUE(project_onto_unlocked_axes(inverse_B.asDiagonal(), factor, Vector3(4, 5, 6)).allFinite());
    }
  }
  EXPECT_EQ(project_onto_unlocked_axes(Vector3(0, 0, 1).asDiagonal(), Vector3(0, 0, 1), Vector3(0, 0, 4)),
            Vector3(0, 0, 4));
}

TEST(ProjectionOntoUnlockedAxes, LeavesNothingWhereAllIsLocked) {
  const Matrix3 inverse = inverse_inertia_W(Matrix3::Identity(), Vector3(1, 2, 3));
  EXPECT_EQ(project_onto_unlocked_axes(inverse, Vector3(0, 0, 0), Vector3(4, 5, 6)), Vector3::Zero());
}

// A factor between 0 and 1 scales torques and locks nothing.
TEST(ProjectionOntoUnlockedAxes, LeavesAScaledAxisAlone) {
  const Matrix3 inverse = inverse_inertia_W(Matrix3::Identity(), Vector3(1, 2, 3));
  EXPECT_EQ(project_onto_unlocked_axes(inverse, Vector3(0.5, 0, 1), Vector3(4, 5, 6)), Vector3(4, 0, 6));
}

}  // namespace
}  // namespace polhode::testing
