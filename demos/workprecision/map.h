#pragma once

#include "workprecision/cell_map.h"
#include "workprecision/options.h"
#include "workprecision/ranks.h"

namespace polhode::demos {

/// Computes the map with all ranks and their threads, going on from a journal if there is one, and writes its
/// files. The same bytes for any number of ranks and threads. Called by all ranks together.
/// @throws std::exception that says what is wrong and what is valid; then no file but the journal was written
void make_map(const CellMap& map, const MapRun& run, Ranks& ranks);

}  // namespace polhode::demos
