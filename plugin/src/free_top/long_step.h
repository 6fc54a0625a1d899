#pragma once

#include "free_top/free_top_step.h"
#include "free_top/motion.h"

namespace polhode::free_top {

/// Sets the constants of a step of several radians. Requires the order in step.kind, and step.L. `length` is
/// |L|.
void set_long_step(FreeTopStep<double>& step, const Motion<double>& motion, double parity, double length);

/// Sets the turn by `angle` about L, which is taken in addition to the substeps.
void set_turn_about_L(FreeTopStep<double>& step, double angle, double length);

/// Takes one substep and returns its turn.
Quaternion take_substep(FreeTopStep<double>& step);

}  // namespace polhode::free_top
