#pragma once

#include "fuzz/world/multibody_slot.h"
#include "fuzz/world/operation.h"

namespace polhode::fuzz {

/// Performs an operation that affects a multibody only, not the world or the library.
void change_multibody(const Operation& operation, MultibodySlot& slot);

}  // namespace polhode::fuzz
