#pragma once

#include <filesystem>
#include <string>

#include "scenario/json_file.h"
#include "scenario/scenario.h"

namespace polhode::demos {

/// Reads the scenario in a file. Without a "name" it gets the file's name.
/// @throws ScenarioError
Scenario read_scenario(const std::filesystem::path& file);

/// Reads the scenario in a JSON text; `file_name` is for messages.
/// @throws ScenarioError
Scenario parse_scenario(const std::string& text, const std::string& file_name);

}  // namespace polhode::demos
