#pragma once

#include <cstdint>

#include "workprecision/joints/joint_scene.h"

namespace polhode::demos {

/// The results of a scene's run to its end or to the divergence. The scene settles in the first second, in
/// which only a divergence counts.
struct JointMotion {
  std::int64_t steps = 0;  ///< completed steps
  bool diverged = false;   ///< the next step failed
  double worst_joint_error = 0.0;
  double worst_energy_gain = 0.0;  ///< largest E/E0
  double worst_speed_error = 0.0;
};

/// @throws Interrupted
JointMotion follow(JointScene& scene, double dt_s, std::int64_t steps);

}  // namespace polhode::demos
