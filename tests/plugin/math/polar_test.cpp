#include "math/polar.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "support/random_body.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using formulas::nearest_rotation;
using testing::same_bits;

class NearestRotation : public ::testing::Test {
 protected:
  Matrix3 random_rotation() { return random_.q_WB().toRotationMatrix(); }
  Matrix3 random_with(const Vector3& singular_values) {
    return random_rotation() * singular_values.asDiagonal() * random_rotation();
  }
  double log_uniform(double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>()(generator_));
  }

  static Quaternion nearest(const Matrix3& R) { return nearest_rotation<double>(R, Quaternion::Identity()); }

  testing::RandomBody random_{21};
  std::mt19937 generator_{22};
};

// Returns U V^T of the singular value decomposition, in extended precision where available.
Quaternion nearest_by_decomposition(const Matrix3& R) {
  using Long = Eigen::Matrix<long double, 3, 3>;
  const Eigen::JacobiSVD<Long> svd(R.cast<long double>(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Long rotation = svd.matrixU() * svd.matrixV().transpose();
  return Quaternion(Eigen::Quaternion<long double>(rotation).normalized().cast<double>());
}

double difference(const Quaternion& a, const Quaternion& b) {
  return std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

TEST_F(NearestRotation, OfARotationTimesANumberIsTheRotation) {
  for (int i = 0; i < 10000; ++i) {
    const Quaternion q = random_.q_WB();
    const Matrix3 R = log_uniform(1e-4, 1e4) * q.toRotationMatrix();
    // measured 4.6e-16
    EXPECT_LE(difference(nearest(R), q), 1e-15);
  }
  EXPECT_EQ(nearest(Matrix3::Identity()).coeffs(), Quaternion::Identity().coeffs());
}

// Rotations by half a turn or nearly so, where the scalar part of the quaternion vanishes.
TEST_F(NearestRotation, OfAHalfTurnIsAccurate) {
  for (const double less_than_half_turn : {0.0, 1e-300, 1e-12, 1e-8, 1e-4, 1e-2}) {
    for (int i = 0; i < 100; ++i) {
      Vector3 axis = random_.omega_W().normalized();
      if (i < 3) axis = Vector3::Unit(i);
      Quaternion q;
      q.w() = std::sin(0.5 * less_than_half_turn);
      q.vec() = std::cos(0.5 * less_than_half_turn) * axis;
      // measured 3.7e-16
      EXPECT_LE(difference(nearest(q.toRotationMatrix()), q), 1e-15);
    }
  }
}

// Rounding of R inevitably turns the nearest rotation by the rounding divided by the sum of the two smaller
// singular values.
TEST_F(NearestRotation, IsThatOfTheSingularValueDecomposition) {
  for (const double condition : {1.01, 1.1, 2.0, 10.0, 1e2, 1e4, 1e6, 1e8}) {
    for (int i = 0; i < 2000; ++i) {
      const double largest = log_uniform(1e-4, 1e4);
      const double middle = largest * log_uniform(1.0 / condition, 1.0);
      const double smallest = largest / condition;
      const Matrix3 R = random_with({largest, middle, smallest});
      // measured 5.0e-16
      EXPECT_LE(difference(nearest(R), nearest_by_decomposition(R)) * (middle + smallest) / largest, 2e-15)
          << condition;
    }
  }
}

// Matrices as made by the scheme `matrix`, which swell across the axis.
TEST_F(NearestRotation, OfASwollenBodyIsAccurateToRounding) {
  for (const double swelling : {1.0, 1.001, 1.5, 10.0, 1e3, 1e4}) {
    for (int i = 0; i < 1000; ++i) {
      const Matrix3 R = random_with({swelling, swelling, 1.0});
      // measured 4.4e-16
      EXPECT_LE(difference(nearest(R), nearest_by_decomposition(R)), 2e-15) << swelling;
    }
  }
}

TEST_F(NearestRotation, IsAUnitQuaternionWhateverTheMatrix) {
  for (int i = 0; i < 20000; ++i) {
    Matrix3 R = random_with({log_uniform(1e-9, 1e9), log_uniform(1e-9, 1e9), -log_uniform(1e-9, 1e9)});
    if (i % 2 == 0) R = R.array().round().cwiseMax(-2.0).cwiseMin(2.0);  // includes singular ones
    EXPECT_NEAR(nearest(R).norm(), 1.0, 1e-15);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, 5e-324, 1e-200, 1e-100, 1e100, 1e153, 1e200, 1e308, infinity, std::nan("")}) {
    Matrix3 one_bad = Matrix3::Identity();
    one_bad(1, 2) = x;
    for (const Matrix3& R : {Matrix3(Matrix3::Constant(x)), Matrix3(x * Matrix3::Identity()), one_bad}) {
      EXPECT_NEAR(nearest(R).norm(), 1.0, 1e-15) << R;
    }
  }
}

// det R < 0, which no step produces: the polar factor is not a rotation, but that of -R is.
TEST_F(NearestRotation, OfAReflectedMatrixIsThatOfItsNegative) {
  for (int i = 0; i < 1000; ++i) {
    const Matrix3 R = random_with({1.0, log_uniform(0.1, 1.0), log_uniform(0.1, 1.0)});
    EXPECT_LE(difference(nearest(-R), nearest(R)), 1e-15);
  }
}

TEST_F(NearestRotation, TakesTheSignOfTheQuaternionBefore) {
  for (int i = 0; i < 1000; ++i) {
    const Quaternion before = random_.q_WB();
    const Quaternion q = nearest_rotation<double>(random_rotation(), before);
    EXPECT_GE(q.coeffs().dot(before.coeffs()), 0.0);
  }
}

// A lane that needs few iterations waits for the others unchanged.
TEST_F(NearestRotation, InALaneDoesNotDependOnTheOthers) {
  for (int i = 0; i < 1000; ++i) {
    Matrix3Wide R_lanes;
    std::array<Matrix3, kLanes> R;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const double condition = std::pow(10.0, static_cast<double>(lane));
      R[lane] = random_with({1.0, log_uniform(1.0 / condition, 1.0), 1.0 / condition});
      if (lane == 5 && i % 2 == 0) R[lane](0, 0) = std::nan("");
      for (int k = 0; k < 9; ++k) R_lanes.coeffRef(k).set(lane, R[lane].coeff(k));
    }
    const QuaternionWide together = nearest_rotation<Wide>(R_lanes, QuaternionWide::Identity());
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const QuaternionWide alone = nearest_rotation<Wide>(R[lane].cast<Wide>(), QuaternionWide::Identity());
      for (int k = 0; k < 4; ++k) {
        EXPECT_TRUE(same_bits(together.coeffs()[k][lane], alone.coeffs()[k][lane])) << lane;
      }
    }
  }
}

}  // namespace
}  // namespace polhode
