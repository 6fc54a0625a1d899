#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "simd/wide.h"

/// Compares the momentum L_B of a FreeTopStep with found_L_B = q_WB^-1 L_W of the state to be stepped. Real
/// is double or Wide.
namespace polhode::free_top {

/// Returns true if the two differ only by rounding. False for an empty step, whose momentum is 0.
template <class Real>
POLHODE_INLINE auto is_same_momentum(const Eigen::Matrix<Real, 3, 1>& L_B,
                                     const Eigen::Matrix<Real, 3, 1>& found_L_B) {
  constexpr double kSame = 1e-14;
  return Eigen::Matrix<Real, 3, 1>(L_B - found_L_B).squaredNorm() < kSame * kSame * found_L_B.squaredNorm();
}

/// Returns the smallest turn that takes L_B to found_L_B. First order is enough for 1e-16 rad. Apply before
/// the step's own turn: otherwise the two momenta would drift apart by rounding, as a random walk.
template <class Real>
POLHODE_INLINE Eigen::Quaternion<Real, Eigen::DontAlign> alignment(
    const Eigen::Matrix<Real, 3, 1>& L_B, const Eigen::Matrix<Real, 3, 1>& found_L_B) {
  const Eigen::Matrix<Real, 3, 1> half_turn_B = L_B.cross(found_L_B) * (0.5 / L_B.squaredNorm());
  return {Real(1.0), half_turn_B[0], half_turn_B[1], half_turn_B[2]};
}

}  // namespace polhode::free_top
