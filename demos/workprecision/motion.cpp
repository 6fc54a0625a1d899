#include "workprecision/motion.h"

#include <algorithm>
#include <cmath>

#include "command_line/interruption.h"
#include "polhode/rotation_limits.h"

namespace polhode::demos {

Motion follow(Kernel& kernel, std::int64_t steps) {
  Motion motion;
  kernel.restart();
  const double start_energy_J = kernel.state().energy();
  while (motion.steps < steps) {
    throw_if_interrupted();
    kernel.run(1);
    const RotationState state = kernel.state();
    if (!within_limits(state)) {
      motion.diverged = true;
      return motion;
    }
    ++motion.steps;
    motion.worst_energy_error =
        std::max(motion.worst_energy_error, std::abs(state.energy() / start_energy_J - 1.0));
  }
  return motion;
}

}  // namespace polhode::demos
