#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace polhode::demos {

/// Returns the directory of the named scenarios: $POLHODE_SCENARIOS, else the share directory that was
/// installed with this executable, even if both were moved.
/// @throws ScenarioError if there is no such directory.
std::filesystem::path scenario_directory();

/// The names in that directory, sorted.
std::vector<std::string> scenario_names();

/// The scenario of that name, or in that file: a text with a '/' or ending in ".json" is a file.
/// @throws ScenarioError
Scenario find_scenario(const std::string& name_or_file);

}  // namespace polhode::demos
