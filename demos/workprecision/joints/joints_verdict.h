#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workprecision/joints/joints_grid.h"

namespace polhode::demos {

/// Counts the cells in which a scheme is worse than Bullet's default, bullet:implicit_body. A cell that
/// diverged is worse in every figure than one that did not.
struct JointsVerdict {
  std::string scheme;
  std::int64_t cells = 0;
  std::int64_t cells_with_energy = 0;  ///< all cells except those of the motor
  std::int64_t worse_joint_error = 0;
  std::int64_t worse_energy_gain = 0;
  std::int64_t worse_speed_error = 0;  ///< of the motor's cells
  std::int64_t diverged = 0;
  std::int64_t bullet_diverged = 0;
  /// The largest excess of its joint error over the worst of Bullet's modes, in the cells up to kResolved in
  /// which neither the scheme nor a mode diverged; 0 if there is no excess.
  double joint_error_excess = 0.0;
};

/// A figure is worse only if it exceeds Bullet's by more than this.
inline constexpr double kJointErrorMargin = 1e-3;  // rad
inline constexpr double kEnergyGainFloor = 1.02;   // E/E0 up to here is never worse
inline constexpr double kEnergyGainFactor = 1.02;
inline constexpr double kSpeedErrorMargin = 1e-2;

/// rad a step. Up to here a step resolves the gyroscopic motion, so a stricter criterion applies.
inline constexpr double kResolved = 0.5;

/// Returns the verdict of each scheme of the grid.
std::vector<JointsVerdict> joints_verdicts(const JointsGrid& grid, const std::vector<CellResult>& results);

/// Returns the verdict in one line.
std::string to_string(const JointsVerdict& verdict);

}  // namespace polhode::demos
