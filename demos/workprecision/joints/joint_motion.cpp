#include "workprecision/joints/joint_motion.h"

#include <algorithm>
#include <cmath>

#include "command_line/interruption.h"

namespace polhode::demos {

JointMotion follow(JointScene& scene, double dt_s, std::int64_t steps) {
  // 1/60 s is slightly less than its double: step 60 is in the first second.
  const std::int64_t first_second = std::llround(std::ceil(1.0 / dt_s - 1e-6));
  JointMotion motion;
  while (motion.steps < steps) {
    throw_if_interrupted();
    scene.step();
    if (scene.diverged()) {
      motion.diverged = true;
      return motion;
    }
    if (++motion.steps <= first_second) continue;
    motion.worst_joint_error = std::max(motion.worst_joint_error, scene.joint_error());
    motion.worst_energy_gain =
        std::max(motion.worst_energy_gain, scene.energy_J() / scene.reference_energy_J());
    motion.worst_speed_error = std::max(motion.worst_speed_error, scene.speed_error());
  }
  return motion;
}

}  // namespace polhode::demos
