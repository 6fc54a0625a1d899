#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace polhode::demos {

/// Returns the directory of the named scenarios: $POLHODE_SCENARIOS, or else the share directory installed
/// with this executable, even if both were moved.
/// @throws ScenarioError if there is no such directory
std::filesystem::path scenario_directory();

/// Returns the names in that directory, sorted.
std::vector<std::string> scenario_names();

/// Returns the scenario with this name, or in this file: a text that contains '/' or ends in ".json" is a
/// file.
/// @throws ScenarioError
Scenario find_scenario(const std::string& name_or_file);

}  // namespace polhode::demos
