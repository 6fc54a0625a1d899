#include "workprecision/joints/joints_grid.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "workprecision/axes_json.h"
#include "workprecision/joints/joint_motion.h"

namespace polhode::demos {

std::vector<Contender> schemes_and_bullet(const std::vector<std::string>& scheme_names) {
  std::vector<std::string> names = scheme_names;
  if (names.empty()) names = {"exact"};
  for (const std::string& name : names) find_scheme(name);  // refuses Bullet's modes
  for (const char* mode : {"none", "explicit", "implicit_world", "implicit_body"}) {
    names.push_back(std::string("bullet:") + mode);
  }
  return find_contenders(names);
}

std::int64_t JointsGrid::cells_of_each() const {
  return static_cast<std::int64_t>(kinds.size()) * omega_dt.count * inertia_ratio.count * tilt.count;
}

std::int64_t JointsGrid::steps() const {
  return std::llround(time_s / dt_s);
}

JointCell joint_cell_at(const JointsGrid& grid, std::int64_t index) {
  JointCell cell{};
  cell.tilt = grid.tilt.at(index % grid.tilt.count);
  index /= grid.tilt.count;
  cell.inertia_ratio = grid.inertia_ratio.at(index % grid.inertia_ratio.count);
  index /= grid.inertia_ratio.count;
  cell.omega_dt = grid.omega_dt.at(index % grid.omega_dt.count);
  const std::size_t row = static_cast<std::size_t>(index / grid.omega_dt.count);
  cell.kind = grid.kinds[row % grid.kinds.size()];
  cell.contender = row / grid.kinds.size();
  return cell;
}

CellResult JointsGrid::computed(std::int64_t index) const {
  const JointCell cell = joint_cell_at(*this, index);
  const auto scene = make_joint_scene(cell.kind, contenders[cell.contender],
                                      {cell.omega_dt, cell.inertia_ratio, cell.tilt, dt_s});
  const JointMotion motion = follow(*scene, dt_s, steps());
  if (motion.diverged) return {index, {}, motion.steps + 1};
  return {index, {motion.worst_joint_error, motion.worst_energy_gain, motion.worst_speed_error}, 0};
}

std::string JointsGrid::description() const {
  nlohmann::ordered_json json = description_start("polhode_workprecision joints 1");
  for (const JointKind kind : kinds) json["kinds"].push_back(to_string(kind));
  json["omega_dt"] = axis_json(omega_dt);
  json["inertia_ratio"] = axis_json(inertia_ratio);
  json["tilt"] = axis_json(tilt);
  json["dt_s"] = dt_s;
  json["time_s"] = time_s;
  return json.dump();
}

std::int64_t JointsGrid::cells_in_round() const {
  constexpr std::int64_t kSteps = 30000;
  return std::clamp<std::int64_t>(kSteps / steps(), 1, 1000);
}

}  // namespace polhode::demos
