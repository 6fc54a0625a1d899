#pragma once

#include "scenario/scenario.h"

namespace polhode::demos {

/// The parts of a scenario that a user can change in the viewer.
struct Changes {
  double dt;
  Vector3 inertia_B;
  Vector3 omega_W;
};

Changes changes_of(const Scenario& resolved_scenario);

/// Returns the scenario with these changes. Does not check its start.
/// @throws std::invalid_argument that says what is valid
Scenario changed(Scenario scenario, const Changes& changes);

}  // namespace polhode::demos
