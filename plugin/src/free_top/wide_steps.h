#pragma once

#include <bitset>

#include "free_top/free_top_step.h"
#include "scheme_base/wide_state.h"

/// The step of `exact` for eight bodies, if it is a single substep.
namespace polhode::free_top {

/// Takes the steps of the bodies in `mask` with their FreeTopSteps. Prepares a new FreeTopStep for a body
/// that is kicked or whose motion has changed. Returns the lanes of `mask` that are left unchanged, because
/// their steps are not short. `memory` holds the numbers of the FreeTopSteps (FreeTopStep::for_each_number),
/// or is null.
std::bitset<kLanes> take_short_steps(const WideStepInput& input, const WideMask& mask, WideState& state,
                                     Wide* memory) noexcept;

/// @name Access to the FreeTopStep of one body
/// @{
void get_lane(std::size_t lane, const Wide* memory, FreeTopStep<double>& result);
void set_lane(std::size_t lane, const FreeTopStep<double>& step, Wide* memory);
/// @}

}  // namespace polhode::free_top
