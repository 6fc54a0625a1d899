#pragma once

#include <cstdint>

#include "workprecision/kernel.h"

namespace polhode::demos {

/// The results of a kernel's run from the start, to its end or to the divergence.
struct Motion {
  std::int64_t steps = 0;           ///< completed steps
  bool diverged = false;            ///< the next step failed: not finite, too fast or too swollen
  double worst_energy_error = 0.0;  ///< largest |E/E0 - 1|
};

/// Requires a spinning body. Leaves the kernel where the motion ended.
/// @throws Interrupted
Motion follow(Kernel& kernel, std::int64_t steps);

}  // namespace polhode::demos
