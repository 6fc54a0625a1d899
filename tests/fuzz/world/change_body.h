#pragma once

#include "fuzz/world/body_slot.h"
#include "fuzz/world/operation.h"

namespace polhode::fuzz {

/// Performs an operation that affects a body only, not the world or the library.
void change_body(const Operation& operation, BodySlot& slot);

}  // namespace polhode::fuzz
