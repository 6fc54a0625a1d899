#pragma once

#include <array>
#include <bitset>

#include "free_top/free_top_step.h"
#include "lanes/lane_step.h"

/// The step of `exact` for eight bodies, where it is a single substep.
namespace polhode::free_top {

/// The lanes whose bodies a function leaves as they are.
using LanesLeft = std::bitset<kLanes>;

/// Takes the step of each body by its FreeTopStep, which it makes anew where that was made for another motion
/// or the solver changed the velocity (kick_drift.h). Leaves bodies whose step is not short, and those at
/// rest.
void take_steps(const LaneInput& input, const std::array<FreeTopStep*, kLanes>& steps, LaneState& state,
                LanesLeft& left) noexcept;

}  // namespace polhode::free_top
