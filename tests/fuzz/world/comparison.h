#pragma once

#include <cstddef>

#include "fuzz/world/side.h"

namespace polhode::fuzz {

/// Fails unless bodies, multibodies and what the library knows of them are the same on both sides, to the bit.
void compare(const Side& here, const Side& there, std::size_t world);

}  // namespace polhode::fuzz
