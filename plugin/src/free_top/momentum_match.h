#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "simd/wide.h"

/// The momentum that a FreeTopStep has in body axes, and found_L_B = q_WB^-1 L_W of the state that it is to
/// step. Real is double or Wide.
namespace polhode::free_top {

/// Returns whether the two differ by rounding only. The momentum of an empty step, which is 0, is no body's.
template <class Real>
POLHODE_INLINE auto is_same_momentum(const Eigen::Matrix<Real, 3, 1>& L_B,
                                     const Eigen::Matrix<Real, 3, 1>& found_L_B) {
  constexpr double kSame = 1e-14;
  return Eigen::Matrix<Real, 3, 1>(L_B - found_L_B).squaredNorm() < kSame * kSame * found_L_B.squaredNorm();
}

/// The smallest turn that takes L_B to found_L_B; first order is enough, for it is of 1e-16 rad. To be taken
/// before the step's own turn: by rounding alone the two momenta would part, as a random walk.
template <class Real>
POLHODE_INLINE Eigen::Quaternion<Real, Eigen::DontAlign> alignment(
    const Eigen::Matrix<Real, 3, 1>& L_B, const Eigen::Matrix<Real, 3, 1>& found_L_B) {
  const Eigen::Matrix<Real, 3, 1> half_turn_B = L_B.cross(found_L_B) * (0.5 / L_B.squaredNorm());
  return {Real(1.0), half_turn_B[0], half_turn_B[1], half_turn_B[2]};
}

}  // namespace polhode::free_top
