#pragma once

#include <nlohmann/json.hpp>

#include "scenario/scenario.h"

namespace polhode::demos {

/// Returns the scenario with all defaults written out; reads back as the same scenario.
nlohmann::ordered_json scenario_json(Scenario scenario);

}  // namespace polhode::demos
