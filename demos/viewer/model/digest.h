#pragma once

#include <cstdint>

#include "viewer/model/history.h"

namespace polhode::demos {

/// A number that stands for all bits of what a contender's world shows after a step; never 0.
std::uint64_t digest_of(const Snapshot& snapshot);

}  // namespace polhode::demos
