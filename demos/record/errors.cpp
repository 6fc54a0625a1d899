#include "record/errors.h"

#include <cmath>

#include "polhode/rotation_math.h"

namespace polhode::demos {

std::optional<double> energy_error(const Sample& sample, const Sample& start) {
  if (start.energy_J == 0.0) return std::nullopt;
  return sample.energy_J / start.energy_J - 1.0;
}

std::optional<double> momentum_error(const Sample& sample, const Sample& start) {
  if (start.state.L_W.isZero(0.0)) return std::nullopt;
  return sample.state.L_W.norm() / start.state.L_W.norm() - 1.0;
}

std::optional<double> momentum_angle_rad(const Sample& sample, const Sample& start) {
  if (start.state.L_W.isZero(0.0)) return std::nullopt;
  const Vector3& L_W = sample.state.L_W;
  return std::atan2(L_W.cross(start.state.L_W).norm(), L_W.dot(start.state.L_W));
}

bool is_past_cut(const Sample& sample, double dt) {
  return sample.state.omega_W.norm() * dt > kBulletTurnLimit;
}

}  // namespace polhode::demos
