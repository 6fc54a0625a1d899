#pragma once

#include <string>
#include <vector>

#include "workprecision/map_grid.h"

/// A map as text, cells by their index; demos/README.md documents columns and keys.
namespace polhode::demos {

std::string map_csv(const MapGrid& grid, const std::vector<CellResult>& results);
std::string map_json(const MapGrid& grid, const std::vector<CellResult>& results);
/// Per contender, how much of the grid stayed sound and how well: for the terminal.
std::string map_summary(const MapGrid& grid, const std::vector<CellResult>& results);

}  // namespace polhode::demos
