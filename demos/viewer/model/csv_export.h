#pragma once

#include <filesystem>

#include "viewer/model/simulation.h"

namespace polhode::demos {

/// Writes the kept steps of every contender, up to the step shown, in the format of polhode_compare.
/// @throws std::runtime_error if the file cannot be written
void export_csv(const Simulation& simulation, const std::filesystem::path& file);

}  // namespace polhode::demos
