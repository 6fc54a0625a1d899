#pragma once

#include "scenario/scenario.h"

namespace polhode::demos {

struct StartMotion {
  Vector3 omega_W;
  Vector3 velocity_W;
};

/// How the body moves at the start: its velocities as the file gives them, and on top what its impulses did.
/// @throws std::invalid_argument if the impulses make it faster than a scenario may say.
StartMotion start_motion(const Body& body, const Vector3& inertia_B);

}  // namespace polhode::demos
