#pragma once

#include <bitset>

#include "free_top/lane_bodies.h"

/// The step of `exact` for the bodies of a LaneBodies, where it is a single substep.
namespace polhode::free_top {

/// The lanes whose bodies a function leaves as they are.
using LanesLeft = std::bitset<kLanes>;

/// For bodies on which nothing acts and whose FreeTopStep was made for their inertia and dt and is short.
/// Leaves those whose momentum it has not.
LanesLeft take_steps(const LaneBodies& bodies) noexcept;

/// For bodies whose FreeTopStep is to be made, after what the solver changed (see kick_drift.h) if anything.
/// Leaves those for which it is not short, and those at rest.
LanesLeft make_and_take_steps(const LaneBodies& bodies) noexcept;

}  // namespace polhode::free_top
