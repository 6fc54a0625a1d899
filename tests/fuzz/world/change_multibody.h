#pragma once

#include "fuzz/world/multibody_slot.h"
#include "fuzz/world/operation.h"

namespace polhode::fuzz {

/// Does an operation that touches a multibody alone, not the world or the library.
void change_multibody(const Operation& operation, MultibodySlot& slot);

}  // namespace polhode::fuzz
