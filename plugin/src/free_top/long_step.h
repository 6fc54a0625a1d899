#pragma once

#include "free_top/free_top_step.h"
#include "free_top/motion.h"

namespace polhode::free_top {

/// Sets the constants of a step of several radians; step.kind has its order, and step.L is set. length is
/// |L|.
void set_long_step(FreeTopStep<double>& step, const Motion<double>& motion, double parity, double length);

/// Sets the turn by `angle` about L that is apart from the substeps.
void set_turn_about_L(FreeTopStep<double>& step, double angle, double length);

/// One of the step's substeps: returns the turn.
Quaternion take_substep(FreeTopStep<double>& step);

}  // namespace polhode::free_top
