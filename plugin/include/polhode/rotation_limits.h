#pragma once

#include "polhode/rotation_state.h"

namespace polhode {

/// Past these a scheme counts as diverged.

/// rad/s. The rim of a body of one metre would be three times as fast as light. Leaves room in single
/// precision for the products that Bullet's solver forms of a body's velocity and its neighbours'.
inline constexpr double kMaximumAngularSpeed = 1e9;

/// The longest column of R_WB: a body ten thousand times its size. Further on R R^T, squared in the velocity,
/// would only overflow.
inline constexpr double kMaximumSwelling = 1e4;

/// Whether a body in this state has not diverged.
inline bool within_limits(const RotationState& state) {
  // What is not a number is not less than anything either.
  return state.omega_W.squaredNorm() <= kMaximumAngularSpeed * kMaximumAngularSpeed &&
         state.R_WB.colwise().squaredNorm().maxCoeff() <= kMaximumSwelling * kMaximumSwelling &&
         state.all_finite();
}

}  // namespace polhode
