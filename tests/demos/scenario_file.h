#pragma once

#include <filesystem>
#include <string>

#include "scenario/scenario_reader.h"

namespace polhode::demos {

/// Reads one of the demos' scenarios from the source tree.
inline Scenario scenario_file(const std::string& name) {
  return read_scenario(std::filesystem::path(POLHODE_SCENARIO_SOURCES) / (name + ".json"));
}

}  // namespace polhode::demos
