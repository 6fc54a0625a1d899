#pragma once

#include "multithreading/run.h"

namespace polhode::testing {

/// 2,000 bodies that never meet, under every built-in scheme: spins of 0.01 to 100 rad/s, at which some
/// schemes diverge and `matrix` swells until it is stopped. Some are kicked in each step, some under a
/// torque, some damped, some asleep from the start or tired; and into a few comes a NaN.
const Play& free_bodies();

/// 16 piles of 33 boxes each on one floor, under every built-in scheme (or plain Bullet).
const Play& piles();

}  // namespace polhode::testing
