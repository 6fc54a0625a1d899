#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workprecision/joints/joints_grid.h"

namespace polhode::demos {

/// In how many cells a scheme is worse than Bullet's default, bullet:implicit_body. A cell that diverged is
/// worse in everything than one that did not.
struct JointsVerdict {
  std::string scheme;
  std::int64_t cells = 0;
  std::int64_t cells_with_energy = 0;  ///< all but the motor's
  std::int64_t worse_joint_error = 0;
  std::int64_t worse_energy_gain = 0;
  std::int64_t worse_speed_error = 0;  ///< of the motor's
  std::int64_t diverged = 0;
  std::int64_t bullet_diverged = 0;
  /// How far its joint error goes above the worst of Bullet's modes, in cells of up to kResolved that are
  /// sound with all of them; 0 if nowhere.
  double joint_error_excess = 0.0;
};

/// By how much a figure may be above Bullet's: more is worse.
inline constexpr double kJointErrorMargin = 1e-3;  // rad
inline constexpr double kEnergyGainFloor = 1.02;   // E/E0 up to here is never worse
inline constexpr double kEnergyGainFactor = 1.02;
inline constexpr double kSpeedErrorMargin = 1e-2;

/// rad a step: up to here a step resolves the gyroscopic motion, and a scheme is held to more.
inline constexpr double kResolved = 0.5;

/// One for each scheme of the grid.
std::vector<JointsVerdict> joints_verdicts(const JointsGrid& grid, const std::vector<CellResult>& results);

/// In one line.
std::string to_string(const JointsVerdict& verdict);

}  // namespace polhode::demos
