#pragma once

#include <LinearMath/btTransform.h>

#include <cstddef>
#include <vector>

namespace polhode::benchmarks {

inline constexpr btScalar kTimeStep = btScalar(1.0 / 60.0);  // s

/// The start of a box.
struct BoxStart {
  std::size_t shape;  ///< index into SceneStart::half_extents
  btScalar mass_kg;
  btTransform pose;
  btVector3 velocity_W;
  btVector3 omega_W;
};

/// The start shared by the plain world and Polhode's.
struct SceneStart {
  std::vector<btVector3> half_extents;  ///< half extents of the shapes, which boxes share
  std::vector<BoxStart> boxes;
  bool floor = false;  ///< true: a static floor, its top at height 0, z up
  btVector3 gravity{0, 0, 0};
};

/// Returns boxes of different inertia that spin by 0.05 to 0.15 rad per step and never meet, without gravity.
SceneStart free_flight(std::size_t count);

/// Returns boxes in staggered layers on a floor, as settled by plain Bullet. Computed once for each count.
const SceneStart& settled_pile(std::size_t count);

}  // namespace polhode::benchmarks
