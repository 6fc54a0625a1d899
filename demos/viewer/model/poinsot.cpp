#include "viewer/model/poinsot.h"

#include <algorithm>

namespace polhode::demos {

namespace {

/// Calls `use` with the sample of each of the last steps up to this one.
template <typename Use>
void for_each_sample(const History& history, std::int64_t step, std::int64_t most, const Use& use) {
  const std::int64_t last = std::min(step, history.last_step());
  for (std::int64_t at = std::max(history.first_step(), last - most + 1); at <= last; ++at) {
    use(history.at(at).sample);
  }
}

}  // namespace

std::optional<Poinsot> poinsot_of(const Sample& start, const Vector3& inertia_B, double size) {
  const double energy_J = start.state.energy();
  const double L = start.state.L_W.norm();
  if (!(energy_J > 0.0) || !(L > 0.0)) return std::nullopt;
  const Vector3 half_axes_rad_s = (2.0 * energy_J * inertia_B.cwiseInverse()).cwiseSqrt();
  const double scale = size / half_axes_rad_s.maxCoeff();
  return Poinsot{scale * half_axes_rad_s, scale, start.state.L_W / L, scale * 2.0 * energy_J / L};
}

std::vector<Eigen::Vector3f> polhode_path(const History& history, const Poinsot& poinsot, std::int64_t step,
                                          std::int64_t most) {
  std::vector<Eigen::Vector3f> points_W;
  const Quaternion q_WB = history.at(step).sample.state.q_WB;
  for_each_sample(history, step, most, [&](const Sample& sample) {
    const Vector3 omega_B = sample.state.q_WB.conjugate() * sample.state.omega_W;
    points_W.emplace_back((q_WB * (poinsot.scale * omega_B)).cast<float>());
  });
  return points_W;
}

std::vector<Eigen::Vector3f> herpolhode_path(const History& history, const Poinsot& poinsot,
                                             std::int64_t step, std::int64_t most) {
  std::vector<Eigen::Vector3f> points_W;
  for_each_sample(history, step, most, [&](const Sample& sample) {
    points_W.emplace_back((poinsot.scale * sample.state.omega_W).cast<float>());
  });
  return points_W;
}

}  // namespace polhode::demos
