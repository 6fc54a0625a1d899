#pragma once

#include "simd/wide.h"

namespace polhode {

/// Computes log(end start^-1) / dt in each lane, rad/s: the constant velocity that takes the body from one
/// orientation to the other in dt. Such velocities differ by whole turns; returns the one nearest to
/// near_omega_W: at 200 rad/s and dt = 1/60 s it is 200, not -177. dt may be negative; dt = 0 gives
/// near_omega_W.
void mean_angular_velocities_W(const QuaternionWide& start_q_WB, const QuaternionWide& end_q_WB,
                               const Vector3Wide& near_omega_W, const Wide& dt, Vector3Wide& result) noexcept;

}  // namespace polhode
