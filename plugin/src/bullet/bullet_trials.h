#pragma once

#include <LinearMath/btMatrix3x3.h>

#include <array>
#include <cstring>
#include <random>

#include "bullet/bullet_replay.h"
#include "polhode/bullet/precision.h"

/// What formulas of Bullet's that are repeated here are tried with: Bullet may have been built in another way
/// than they are written, with SSE, with relaxed arithmetic, with another derivative, from another version.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Deterministic poses and velocities; a few that follow one another reach every branch of Bullet's.
class Trials {
 public:
  // Those of the quaternion that are the greatest take turns, with now and then what is no rotation and what
  // exceeds the range of numbers.
  btMatrix3x3 basis() {
    ++number_;
    if (number_ % 15 == 0) return any_matrix(btScalar(0.9) * SIMD_INFINITY);
    if (number_ % 5 == 0) return any_matrix(btScalar(1.0));
    return any_rotation(number_ % 4);
  }

  btVector3 omega_W() {
    constexpr std::array<double, 7> kSpeeds = {0.0, 1e-9, 1e-4, 2e-3, 1.0, 30.0, 1e3};  // rad/s
    return any_vector() * static_cast<btScalar>(kSpeeds[number_ % kSpeeds.size()]);
  }

  btVector3 inverse_inertia_B() { return any_vector(); }

  btScalar dt() { return btScalar(0.02) + btScalar(0.015) * any(); }

 private:
  // Between -1 and 1.
  btScalar any() {
    return static_cast<btScalar>(2.0 * static_cast<double>(generator_()) / std::minstd_rand::max() - 1.0);
  }
  btVector3 any_vector() {
    const btScalar x = any(), y = any(), z = any();
    return {x, y, z};
  }
  btMatrix3x3 any_matrix(btScalar size) {
    const btVector3 x = any_vector() * size, y = any_vector() * size, z = any_vector() * size;
    return {x, y, z};
  }
  btMatrix3x3 any_rotation(std::size_t greatest) {
    std::array<btScalar, 4> q = {any(), any(), any(), any()};
    q[greatest] += btScalar(2.0);
    return btMatrix3x3(btQuaternion(q[0], q[1], q[2], q[3]));
  }

  std::minstd_rand generator_;
  std::size_t number_ = 0;
};

/// Whether `agrees(trials, replay)`, which tries eight bodies, says so as often as that.
template <class Agrees>
bool agrees_each_time(std::size_t times, Agrees agrees) {
  BulletReplay replay;
  Trials trials;
  for (std::size_t i = 0; i < times; ++i) {
    if (!agrees(trials, replay)) return false;
  }
  return true;
}

inline bool same_bits(const btMatrix3x3& a, const btMatrix3x3& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
