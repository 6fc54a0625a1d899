#pragma once

#include <cstdint>
#include <vector>

#include "workprecision/cell_map.h"

namespace polhode::demos {

/// The threads of one rank: those asked for, or without a wish one per core, of several ranks one each.
std::size_t thread_count(std::int64_t wish, int ranks);

/// The results of these cells, in their order. What one thread throws ends all of them.
/// @throws Interrupted
std::vector<CellResult> computed_by_threads(const CellMap& map, const std::vector<std::int64_t>& cells,
                                            std::size_t threads);

}  // namespace polhode::demos
