#pragma once

#include <bitset>

#include "free_top/free_top_step.h"
#include "scheme_base/wide_state.h"

/// The step of `exact` for eight bodies, where it is a single substep.
namespace polhode::free_top {

/// Takes the step of each body in `mask` by its FreeTopStep, which is made anew where it was made for another
/// motion or where the body is kicked. Returns the lanes of `mask` that it leaves as they are: those of steps
/// that are not short.
/// memory: the numbers of the FreeTopSteps (FreeTopStep::for_each_number), or null.
std::bitset<kLanes> take_short_steps(const WideStepInput& input, const WideMask& mask, WideState& state,
                                     Wide* memory) noexcept;

/// @name The FreeTopStep of one body, in and out of the memory
/// @{
void get_lane(std::size_t lane, const Wide* memory, FreeTopStep<double>& result);
void set_lane(std::size_t lane, const FreeTopStep<double>& step, Wide* memory);
/// @}

}  // namespace polhode::free_top
