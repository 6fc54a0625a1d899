#pragma once

#include <cstdint>

#include "viewer/model/history.h"

namespace polhode::demos {

/// Returns a digest of all bits of a contender's world after a step; never 0.
std::uint64_t digest_of(const Snapshot& snapshot);

}  // namespace polhode::demos
