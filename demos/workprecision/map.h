#pragma once

#include "workprecision/cell_map.h"
#include "workprecision/options.h"
#include "workprecision/ranks.h"

namespace polhode::demos {

/// Computes the map with all ranks and their threads, resuming from a journal if there is one, and writes its
/// files. The bytes are the same for any number of ranks and threads. All ranks must call it together.
/// @throws std::exception that says what is wrong and what is valid; no file but the journal is written then
void make_map(const CellMap& map, const MapRun& run, Ranks& ranks);

}  // namespace polhode::demos
