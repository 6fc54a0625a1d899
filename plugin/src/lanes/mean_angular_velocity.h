#pragma once

#include <cstddef>

#include "polhode/rotation_state.h"

namespace polhode {

/// Two orientations of a body, dt apart.
struct OrientationPair {
  const Quaternion* start_q_WB;
  const Quaternion* end_q_WB;
};

/// results[i] = logarithm(end start^-1) / dt of pairs[i], the velocity in rad/s at which the body comes from
/// one to the other by the shorter way. Each pair comes out as if it were alone, to the last bit.
void mean_angular_velocities_W(const OrientationPair* pairs, std::size_t count, double dt,
                               Vector3* results) noexcept;

}  // namespace polhode
