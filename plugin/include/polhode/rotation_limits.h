#pragma once

#include <cmath>

#include "polhode/rotation_state.h"

namespace polhode {

/// Limits beyond which a scheme counts as diverged.

/// Largest |omega_W|, rad/s. At this speed the rim of a body of one metre would move at three times the speed
/// of light. The limit keeps products of velocities in Bullet's solver from overflowing single precision.
inline constexpr double kMaximumAngularSpeed = 1e9;

/// Longest column of R_WB: a body shown at ten thousand times its size. The limit keeps
/// omega_W = R I_B^-1 R^T L_W and its square from overflowing.
inline constexpr double kMaximumSwelling = 1e4;

/// Smallest |q_WB|^2. After a step of more radians than a double can represent, normalizing q_WB yields zero.
inline constexpr double kMinimumQuaternionNorm2 = 0.5;

/// Returns true if the state has not diverged.
inline bool within_limits(const RotationState& state) {
  // Written so that NaN fails the comparisons.
  return state.omega_W.squaredNorm() <= kMaximumAngularSpeed * kMaximumAngularSpeed &&
         state.R_WB.colwise().squaredNorm().maxCoeff() <= kMaximumSwelling * kMaximumSwelling &&
         state.q_WB.squaredNorm() >= kMinimumQuaternionNorm2 && state.all_finite() &&
         std::isfinite(state.energy());
}

}  // namespace polhode
