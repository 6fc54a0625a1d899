#pragma once

#include <LinearMath/btTransform.h>

#include <cstddef>
#include <vector>

namespace polhode::benchmarks {

inline constexpr btScalar kTimeStep = btScalar(1.0 / 60.0);  // s

/// A box at the start of a scene.
struct BoxStart {
  std::size_t shape;  ///< in SceneStart::half_extents
  btScalar mass_kg;
  btTransform pose;
  btVector3 velocity_W;
  btVector3 omega_W;
};

/// The start that the plain world and Polhode's share.
struct SceneStart {
  std::vector<btVector3> half_extents;  ///< of the shapes, which the boxes share
  std::vector<BoxStart> boxes;
  bool floor = false;  ///< static, its top at height 0, z up
  btVector3 gravity{0, 0, 0};
};

/// Boxes of different inertia that spin by 0.05 to 0.15 rad a step, each alone in its place; no gravity.
SceneStart free_flight(std::size_t count);

/// Boxes in staggered layers on a floor, as plain Bullet settled them. Computed once for each count.
const SceneStart& settled_pile(std::size_t count);

}  // namespace polhode::benchmarks
