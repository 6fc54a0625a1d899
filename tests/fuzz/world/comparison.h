#pragma once

#include <cstddef>

#include "fuzz/world/side.h"

namespace polhode::fuzz {

/// Fails unless bodies, multibodies and the library's data about them are bit-identical on both sides.
void compare(const Side& here, const Side& there, std::size_t world);

}  // namespace polhode::fuzz
