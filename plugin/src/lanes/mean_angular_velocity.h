#pragma once

#include <cstddef>

#include "lanes/lanes.h"
#include "polhode/rotation_state.h"

namespace polhode {

/// logarithm(end start^-1) / dt in each lane: the velocity in rad/s at which the body comes from one
/// orientation to the other by the shorter way.
void mean_angular_velocities_W(const QuaternionL& start_q_WB, const QuaternionL& end_q_WB, double dt,
                               Vector3L& result) noexcept;

/// Two orientations of a body, dt apart.
struct OrientationPair {
  const Quaternion* start_q_WB;
  const Quaternion* end_q_WB;
};

/// The same of any number of bodies: results[i] of pairs[i], to the last bit as if it were alone.
void mean_angular_velocities_W(const OrientationPair* pairs, std::size_t count, double dt,
                               Vector3* results) noexcept;

}  // namespace polhode
