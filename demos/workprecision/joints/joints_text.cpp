#include <algorithm>
#include <optional>

#include "record/optional_number.h"
#include "record/table.h"
#include "workprecision/axes_json.h"
#include "workprecision/joints/joints_grid.h"
#include "workprecision/joints/joints_verdict.h"

namespace polhode::demos {

namespace {

using Json = nlohmann::ordered_json;

// The figures that are written for a cell. A missing figure is empty.
struct WrittenFigures {
  std::optional<double> joint_error;
  std::optional<double> energy_gain;
  std::optional<double> speed_error;
};

WrittenFigures figures_of(const CellResult& result, JointKind kind) {
  WrittenFigures figures;
  if (diverged(result)) return figures;
  figures.joint_error = joint_error(result);
  if (kind == JointKind::motor) {
    figures.speed_error = speed_error(result);
  } else {
    figures.energy_gain = energy_gain(result);
  }
  return figures;
}

Json verdict_json(const JointsVerdict& verdict) {
  return {{"scheme", verdict.scheme},
          {"cells", verdict.cells},
          {"worse_joint_error", verdict.worse_joint_error},
          {"cells_with_energy", verdict.cells_with_energy},
          {"worse_energy_gain", verdict.worse_energy_gain},
          {"worse_motor_speed_error", verdict.worse_speed_error},
          {"joint_error_excess", verdict.joint_error_excess},
          {"diverged", verdict.diverged},
          {"bullet_diverged", verdict.bullet_diverged}};
}

/// The worst figures of some cells; empty if no cell has the figure.
struct Worst {
  std::optional<double> joint_error;
  std::optional<double> energy_gain;
  std::optional<double> speed_error;
  std::int64_t diverged = 0;

  void add(const CellResult& result, JointKind kind) {
    const WrittenFigures figures = figures_of(result, kind);
    // An empty optional compares as less than any number.
    joint_error = std::max(joint_error, figures.joint_error);
    energy_gain = std::max(energy_gain, figures.energy_gain);
    speed_error = std::max(speed_error, figures.speed_error);
    diverged += demos::diverged(result) ? 1 : 0;
  }
};

std::vector<std::string> row(const std::string& contender, JointKind kind, const Worst& resolved,
                             const Worst& beyond) {
  constexpr int kDigits = 3;
  return {contender,
          to_string(kind),
          table_cell(resolved.joint_error, kDigits),
          table_cell(beyond.joint_error, kDigits),
          table_cell(resolved.energy_gain, kDigits),
          table_cell(beyond.energy_gain, kDigits),
          table_cell(std::max(resolved.speed_error, beyond.speed_error), kDigits),
          number_text(resolved.diverged + beyond.diverged)};
}

}  // namespace

std::string JointsGrid::csv(const std::vector<CellResult>& results) const {
  std::string text =
      "contender,kind,omega_dt_rad,inertia_ratio,tilt_rad,state,joint_error_rad,energy_gain,"
      "motor_speed_error,diverged_at_step\n";
  for (const CellResult& result : results) {
    const JointCell cell = joint_cell_at(*this, result.index);
    const WrittenFigures figures = figures_of(result, cell.kind);
    text += contenders[cell.contender].name + "," + to_string(cell.kind) + "," +
            full_number_text(cell.omega_dt) + "," + full_number_text(cell.inertia_ratio) + "," +
            full_number_text(cell.tilt) + "," + (diverged(result) ? "diverged" : "finite") + "," +
            csv_cell(figures.joint_error) + "," + csv_cell(figures.energy_gain) + "," +
            csv_cell(figures.speed_error) + "," +
            (diverged(result) ? number_text(result.diverged_step) : "") + "\n";
  }
  return text;
}

std::string JointsGrid::json(const std::vector<CellResult>& results) const {
  Json map = cells_json(results);
  map["tilt"] = axis_values_json(tilt);
  for (const JointsVerdict& verdict : joints_verdicts(*this, results)) {
    map["verdicts"].push_back(verdict_json(verdict));
  }
  return map.dump() + "\n";
}

Json JointsGrid::figures_json(const CellResult& result) const {
  const WrittenFigures figures = figures_of(result, joint_cell_at(*this, result.index).kind);
  return {{"joint_error", json_value(figures.joint_error)},
          {"energy_gain", json_value(figures.energy_gain)},
          {"motor_speed_error", json_value(figures.speed_error)}};
}

std::string JointsGrid::summary(const std::vector<CellResult>& results) const {
  std::vector<std::vector<std::string>> rows = {
      {"contender", "kind", "error to 0.5", "beyond", "E/E0 to 0.5", "beyond", "motor speed", "diverged"}};
  const std::size_t cells = static_cast<std::size_t>(cells_of_each()) / kinds.size();
  for (auto begin = results.begin(); begin != results.end(); begin += static_cast<std::ptrdiff_t>(cells)) {
    Worst resolved;
    Worst beyond;
    const JointCell first = joint_cell_at(*this, begin->index);
    for (auto result = begin; result != begin + static_cast<std::ptrdiff_t>(cells); ++result) {
      const bool is_resolved = joint_cell_at(*this, result->index).omega_dt <= kResolved;
      (is_resolved ? resolved : beyond).add(*result, first.kind);
    }
    rows.push_back(row(contenders[first.contender].name, first.kind, resolved, beyond));
  }
  std::string text = aligned_columns(rows, Align::right);
  for (const JointsVerdict& verdict : joints_verdicts(*this, results)) text += to_string(verdict) + "\n";
  return text;
}

}  // namespace polhode::demos
