#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workprecision/cell_map.h"
#include "workprecision/joints/joint_kind.h"

namespace polhode::demos {

/// Returns the schemes with these names, or `exact` without names, followed by Bullet's four modes for
/// comparison.
/// @throws std::invalid_argument for an unknown name (the message lists the valid ones) or a repeated one
std::vector<Contender> schemes_and_bullet(const std::vector<std::string>& scheme_names);

/// A map with a cell for each contender, kind, |omega| dt, inertia ratio and tilt. The cells of a contender
/// are ordered by kind, then |omega| dt, then ratio.
struct JointsGrid : CellMap {
  JointsGrid() : CellMap(schemes_and_bullet({}), {0.01, 3.0, 16}, {1.0, 20.0, 8}) {}

  std::vector<JointKind> kinds{kJointKinds.begin(), kJointKinds.end()};
  LinearAxis tilt{0.0, 1.5707963267948966, 7};
  double dt_s = 1.0 / 60.0;
  double time_s = 10.0;

  std::int64_t steps() const;

  std::int64_t cells_of_each() const override;
  /// Joint error, energy gain and a motor's speed error, as in JointMotion; all are 0 in a cell that
  /// diverged.
  std::size_t figure_count() const override { return 3; }
  CellResult computed(std::int64_t index) const override;
  std::string description() const override;
  std::int64_t cells_in_round() const override;
  std::string csv(const std::vector<CellResult>& results) const override;
  std::string json(const std::vector<CellResult>& results) const override;
  /// Returns a table of the worst figures, and a line for each scheme: in how many cells it is worse than
  /// Bullet's default.
  std::string summary(const std::vector<CellResult>& results) const override;

 private:
  nlohmann::ordered_json figures_json(const CellResult& result) const override;
};

struct JointCell {
  std::size_t contender;  ///< its index in the grid
  JointKind kind;
  double omega_dt;
  double inertia_ratio;
  double tilt;
};

JointCell joint_cell_at(const JointsGrid& grid, std::int64_t index);

/// Returns the figures of a cell that did not diverge. The energy gain is meaningless for a motor, which does
/// work on its body.
inline double joint_error(const CellResult& result) {
  return result.figures[0];
}
inline double energy_gain(const CellResult& result) {
  return result.figures[1];
}
inline double speed_error(const CellResult& result) {
  return result.figures[2];
}

}  // namespace polhode::demos
