#pragma once

#include <cmath>

#include "polhode/rotation_state.h"

namespace polhode {

/// A scheme counts as diverged beyond these limits.

/// rad/s. At this speed the rim of a body of one metre would be three times as fast as light. The limit
/// leaves room in single precision for the products that Bullet's solver forms of a body's velocity and its
/// neighbours'.
inline constexpr double kMaximumAngularSpeed = 1e9;

/// The longest column of R_WB: a body ten thousand times its size. The limit keeps R R^T, squared in the
/// velocity, from overflowing.
inline constexpr double kMaximumSwelling = 1e4;

/// The least squared norm of q_WB. In a step of more radians than double can count, normalizing leaves nothing of it.
inline constexpr double kMinimumQuaternionNorm2 = 0.5;

/// Returns true if a body in this state has not diverged.
inline bool within_limits(const RotationState& state) {
  // Written so that NaN is not within the limits.
  return state.omega_W.squaredNorm() <= kMaximumAngularSpeed * kMaximumAngularSpeed &&
         state.R_WB.colwise().squaredNorm().maxCoeff() <= kMaximumSwelling * kMaximumSwelling &&
         state.q_WB.squaredNorm() >= kMinimumQuaternionNorm2 && state.all_finite() &&
         std::isfinite(state.energy());
}

}  // namespace polhode
