#include "workprecision/map_grid.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scenario/build_info.h"
#include "workprecision/motion.h"
#include "world/run.h"

namespace polhode::demos {

namespace {

using Json = nlohmann::ordered_json;

Vector3 spin_direction_B(SpinStart start) {
  if (start == SpinStart::generic) return Vector3(3.0, 2.0, 4.0).normalized();
  constexpr double kAside = 0.01;
  return {std::sin(kAside), std::cos(kAside), 0.0};
}

Json axis_json(const LogarithmicAxis& axis) {
  return {axis.from, axis.to, axis.count};
}

}  // namespace

double LogarithmicAxis::at(std::int64_t i) const {
  if (i == 0) return from;
  if (i == count - 1) return to;  // without rounding
  return from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(count - 1));
}

std::int64_t MapGrid::cell_count() const {
  return static_cast<std::int64_t>(contenders.size()) * omega_dt.count * inertia_ratio.count;
}

MapCell cell_at(const MapGrid& grid, std::int64_t index) {
  const std::int64_t ratios = grid.inertia_ratio.count;
  const std::int64_t row = index / ratios;
  return {static_cast<std::size_t>(row / grid.omega_dt.count), grid.omega_dt.at(row % grid.omega_dt.count),
          grid.inertia_ratio.at(index % ratios)};
}

FreeBody body_of(const MapCell& cell, SpinStart start) {
  const double greatest = cell.inertia_ratio;
  const double middle = 0.5 * (std::max(1.0, greatest - 1.0) + greatest);
  FreeBody body;
  body.inertia_B = {1.0, middle, greatest};
  body.omega_W = cell.omega_dt / kMapTimeStep * spin_direction_B(start);
  return body;
}

CellResult computed(const MapGrid& grid, std::int64_t index) {
  const MapCell cell = cell_at(grid, index);
  const auto kernel = make_kernel(grid.contenders[cell.contender], body_of(cell, grid.start), kMapTimeStep);
  const Motion motion = follow(*kernel, grid.steps);
  return {index, motion.worst_energy_error, motion.diverged ? motion.steps + 1 : 0};
}

std::string description(const MapGrid& grid) {
  Json json;
  json["journal"] = "polhode_workprecision map 1";
  json["polhode_version"] = kVersion;
  json["precision"] = bullet_precision();
  for (const Contender& contender : grid.contenders) json["contenders"].push_back(contender.name);
  json["omega_dt"] = axis_json(grid.omega_dt);
  json["inertia_ratio"] = axis_json(grid.inertia_ratio);
  json["steps"] = grid.steps;
  json["start"] = to_string(grid.start);
  return json.dump();
}

std::string to_string(SpinStart start) {
  return start == SpinStart::generic ? "generic" : "middle_axis";
}

}  // namespace polhode::demos
