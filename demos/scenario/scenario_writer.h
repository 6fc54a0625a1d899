#pragma once

#include <nlohmann/json.hpp>

#include "scenario/scenario.h"

namespace polhode::demos {

/// The scenario with every default spelled out; reads back as the same scenario.
nlohmann::ordered_json scenario_json(Scenario scenario);

}  // namespace polhode::demos
