#pragma once

#include "fuzz/world/body_slot.h"
#include "fuzz/world/operation.h"

namespace polhode::fuzz {

/// Does an operation that touches a body alone, not the world or the library.
void change_body(const Operation& operation, BodySlot& slot);

}  // namespace polhode::fuzz
