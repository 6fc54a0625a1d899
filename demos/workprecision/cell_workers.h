#pragma once

#include <cstdint>
#include <vector>

#include "workprecision/cell_map.h"

namespace polhode::demos {

/// Returns the number of threads of one rank: as asked for, or else one per core, and one if there are
/// several ranks.
std::size_t thread_count(std::int64_t wish, int ranks);

/// Returns the results of these cells, in their order. An exception in one thread ends all of them.
/// @throws Interrupted
std::vector<CellResult> computed_by_threads(const CellMap& map, const std::vector<std::int64_t>& cells,
                                            std::size_t threads);

}  // namespace polhode::demos
