#include "workprecision/joints/joints_verdict.h"

#include <algorithm>

#include "scenario/number_text.h"

namespace polhode::demos {

namespace {

// Adds a cell of the scheme and the same cell of Bullet.
void add(JointsVerdict& verdict, JointKind kind, const CellResult& scheme, const CellResult& bullet) {
  const bool motor = kind == JointKind::motor;
  const bool alone_diverged = diverged(scheme) && !diverged(bullet);
  const bool both_sound = !diverged(scheme) && !diverged(bullet);
  const auto worse = [&](double figure, double limit) {
    return alone_diverged || (both_sound && figure > limit) ? 1 : 0;
  };
  ++verdict.cells;
  verdict.diverged += diverged(scheme) ? 1 : 0;
  verdict.bullet_diverged += diverged(bullet) ? 1 : 0;
  verdict.worse_joint_error += worse(joint_error(scheme), joint_error(bullet) + kJointErrorMargin);
  if (motor) {
    verdict.worse_speed_error += worse(speed_error(scheme), speed_error(bullet) + kSpeedErrorMargin);
  } else {
    ++verdict.cells_with_energy;
    verdict.worse_energy_gain +=
        worse(energy_gain(scheme), std::max(kEnergyGainFloor, kEnergyGainFactor * energy_gain(bullet)));
  }
}

// Returns for example "3 of 390".
std::string part_text(std::int64_t part, std::int64_t all) {
  return number_text(part) + " of " + number_text(all);
}

// Returns by how much the scheme's joint error in a cell exceeds the largest of Bullet's modes in the same
// cell. The modes are the contenders from `first_mode` on.
double joint_error_excess(const JointsGrid& grid, const std::vector<CellResult>& results,
                          std::size_t first_mode, const CellResult& scheme) {
  const std::size_t cells = static_cast<std::size_t>(grid.cells_of_each());
  const std::size_t cell = static_cast<std::size_t>(scheme.index) % cells;
  double worst = 0.0;
  for (std::size_t mode = first_mode; mode < grid.contenders.size(); ++mode) {
    const CellResult& result = results[mode * cells + cell];
    if (diverged(result)) return 0.0;
    worst = std::max(worst, joint_error(result));
  }
  return diverged(scheme) ? 0.0 : std::max(0.0, joint_error(scheme) - worst);
}

}  // namespace

std::vector<JointsVerdict> joints_verdicts(const JointsGrid& grid, const std::vector<CellResult>& results) {
  const std::size_t cells = static_cast<std::size_t>(grid.cells_of_each());
  const std::size_t schemes = grid.contenders.size() - 4;  // followed by Bullet's modes, the default last
  const std::size_t bullet_begin = results.size() - cells;
  std::vector<JointsVerdict> verdicts;
  for (std::size_t i = 0; i < schemes; ++i) {
    JointsVerdict verdict;
    verdict.scheme = grid.contenders[i].name;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const CellResult& scheme = results[i * cells + cell];
      const JointCell where = joint_cell_at(grid, scheme.index);
      add(verdict, where.kind, scheme, results[bullet_begin + cell]);
      if (where.omega_dt > kResolved) continue;
      verdict.joint_error_excess =
          std::max(verdict.joint_error_excess, joint_error_excess(grid, results, schemes, scheme));
    }
    verdicts.push_back(verdict);
  }
  return verdicts;
}

std::string to_string(const JointsVerdict& verdict) {
  std::string text = verdict.scheme + " against bullet:implicit_body: joint error worse in " +
                     part_text(verdict.worse_joint_error, verdict.cells) + " cells";
  if (verdict.cells_with_energy > 0) {
    text += ", energy gain in " + part_text(verdict.worse_energy_gain, verdict.cells_with_energy);
  }
  if (verdict.cells > verdict.cells_with_energy) {
    text +=
        ", motor speed in " + part_text(verdict.worse_speed_error, verdict.cells - verdict.cells_with_energy);
  }
  text += "; joint error up to " + short_number_text(kResolved, 3) + " rad a step at most " +
          short_number_text(verdict.joint_error_excess, 3) + " rad above the worst of Bullet's modes";
  return text + "; diverged in " + number_text(verdict.diverged) + " cells (Bullet in " +
         number_text(verdict.bullet_diverged) + ")";
}

}  // namespace polhode::demos
