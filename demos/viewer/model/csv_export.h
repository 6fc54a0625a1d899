#pragma once

#include <filesystem>

#include "viewer/model/simulation.h"

namespace polhode::demos {

/// Writes what is kept of every contender, up to the step that is shown, as polhode_compare writes it.
/// @throws std::runtime_error if the file cannot be written.
void export_csv(const Simulation& simulation, const std::filesystem::path& file);

}  // namespace polhode::demos
