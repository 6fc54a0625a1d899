#pragma once

#include "scenario/scenario.h"

namespace polhode::demos {

struct StartMotion {
  Vector3 omega_W;
  Vector3 velocity_W;
};

/// Returns the body's initial motion: the velocities in the file plus the effect of the impulses.
/// @throws std::invalid_argument if the impulses make the body faster than a scenario allows
StartMotion start_motion(const Body& body, const Vector3& inertia_B);

}  // namespace polhode::demos
