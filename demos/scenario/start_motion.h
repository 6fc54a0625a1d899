#pragma once

#include "scenario/scenario.h"

namespace polhode::demos {

struct StartMotion {
  Vector3 omega_W;
  Vector3 velocity_W;
};

/// Returns the body's motion at the start: the velocities that the file gives, and what the impulses add to
/// them.
/// @throws std::invalid_argument if the impulses make it faster than a scenario may say.
StartMotion start_motion(const Body& body, const Vector3& inertia_B);

}  // namespace polhode::demos
