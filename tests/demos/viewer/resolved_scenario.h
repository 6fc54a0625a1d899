#pragma once

#include <string>

#include "demos/scenario_file.h"
#include "world/body_shape.h"

namespace polhode::demos {

/// Reads one of the demos' scenarios and fills in its body's inertia.
inline Scenario resolved_scenario(const std::string& name) {
  return resolved(scenario_file(name));
}

}  // namespace polhode::demos
