#include "bullet/inertia_tensors.h"

#include <array>

#include "bullet/bullet_lanes.h"
#include "bullet/bullet_trials.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

bool tensors_agree_with_bullet(Trials& trials, BulletReplay& replay) {
  std::array<btMatrix3x3, kLanes> bases;
  std::array<btVector3, kLanes> inverse_inertias_B;
  std::array<btMatrix3x3, kLanes> tensors_W;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    bases[lane] = trials.basis();
    inverse_inertias_B[lane] = trials.inverse_inertia_B();
  }
  const LaneBasis in_lanes = inverse_inertia_tensor_W(
      load_bases([&](std::size_t lane) -> auto& { return bases[lane]; }),
      load_vectors([&](std::size_t lane) -> auto& { return inverse_inertias_B[lane]; }));
  store_bases(
      in_lanes, [&](std::size_t lane) -> auto& { return tensors_W[lane]; });
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const btMatrix3x3 of_bullet = replay.inverse_inertia_tensor_W(bases[lane], inverse_inertias_B[lane]);
    if (!same_bits(tensors_W[lane], of_bullet)) return false;
  }
  return true;
}

}  // namespace

bool inertia_tensors_in_lanes() {
  static const bool result = agrees_each_time(10, tensors_agree_with_bullet);
  return result;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
