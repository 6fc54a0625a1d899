#include "workprecision/map_grid.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "workprecision/axes_json.h"
#include "workprecision/motion.h"

namespace polhode::demos {

namespace {

Vector3 spin_direction_B(SpinStart start) {
  if (start == SpinStart::generic) return Vector3(3.0, 2.0, 4.0).normalized();
  constexpr double kAside = 0.01;
  return {std::sin(kAside), std::cos(kAside), 0.0};
}

}  // namespace

MapCell cell_at(const MapGrid& grid, std::int64_t index) {
  const std::int64_t ratios = grid.inertia_ratio.count;
  const std::int64_t row = index / ratios;
  return {static_cast<std::size_t>(row / grid.omega_dt.count), grid.omega_dt.at(row % grid.omega_dt.count),
          grid.inertia_ratio.at(index % ratios)};
}

Vector3 moments_of(double inertia_ratio) {
  return {1.0, 0.5 * (std::max(1.0, inertia_ratio - 1.0) + inertia_ratio), inertia_ratio};
}

FreeBody body_of(const MapCell& cell, SpinStart start) {
  FreeBody body;
  body.inertia_B = moments_of(cell.inertia_ratio);
  body.omega_W = cell.omega_dt / kMapTimeStep * spin_direction_B(start);
  return body;
}

CellResult MapGrid::computed(std::int64_t index) const {
  const MapCell cell = cell_at(*this, index);
  const auto kernel = make_kernel(contenders[cell.contender], body_of(cell, start), kMapTimeStep);
  const Motion motion = follow(*kernel, steps);
  return {index, {motion.worst_energy_error}, motion.diverged ? motion.steps + 1 : 0};
}

std::int64_t MapGrid::cells_in_round() const {
  constexpr std::int64_t kSteps = 200000;
  return std::clamp<std::int64_t>(kSteps / steps, 1, 1000);
}

std::string MapGrid::description() const {
  nlohmann::ordered_json json = description_start("polhode_workprecision map 1");
  json["omega_dt"] = axis_json(omega_dt);
  json["inertia_ratio"] = axis_json(inertia_ratio);
  json["steps"] = steps;
  json["start"] = to_string(start);
  return json.dump();
}

std::string to_string(SpinStart start) {
  return start == SpinStart::generic ? "generic" : "middle_axis";
}

}  // namespace polhode::demos
