#pragma once

#include <cstdint>

#include "workprecision/kernel.h"

namespace polhode::demos {

/// A kernel's run from the start, step by step, to its end or to the divergence.
struct Motion {
  std::int64_t steps = 0;           ///< that went well
  bool diverged = false;            ///< the next one did not: not finite, too fast or too swollen
  double worst_energy_error = 0.0;  ///< the largest |E/E0 - 1|
};

/// The body must spin. The kernel is left where the motion ended.
/// @throws Interrupted
Motion follow(Kernel& kernel, std::int64_t steps);

}  // namespace polhode::demos
