#pragma once

#include "multithreading/run.h"

namespace polhode::testing {

/// 2,000 bodies that never touch, with every built-in scheme. Their spins of 0.01 to 100 rad/s make some
/// schemes diverge, and `matrix` swell until it is stopped. Some bodies are kicked in each step, have a
/// torque, are damped, start asleep or fall asleep; a few get a NaN.
const Play& free_bodies();

/// 16 piles of 33 boxes on one floor, with every built-in scheme (or plain Bullet).
const Play& piles();

}  // namespace polhode::testing
