#include "record/table.h"

#include <algorithm>

#include "record/optional_number.h"
#include "scenario/build_info.h"
#include "scenario/number_text.h"

namespace polhode::demos {

namespace {

using Row = std::vector<std::string>;

std::string signed_cell(const std::optional<double>& value, int digits) {
  return (value && *value > 0.0 ? "+" : "") + table_cell(value, digits);
}

Row figures_row(const ContenderFigures& contender) {
  const Figures& figures = contender.figures;
  return {contender.contender,
          signed_cell(figures.final_energy_error, 4),
          table_cell(figures.worst_energy_error, 3),
          table_cell(figures.worst_momentum_error, 3),
          table_cell(figures.worst_momentum_angle_rad, 3),
          table_cell(figures.final_attitude_error_rad, 3),
          table_cell(figures.worst_attitude_error_rad, 3),
          short_number_text(figures.final_det_R, 6),
          number_text(figures.steps_past_cut),
          table_cell(figures.diverged_at_s, 6),
          number_text(static_cast<std::int64_t>(figures.ns_per_step))};
}

std::string heading(const Comparison& comparison) {
  const Scenario& scenario = comparison.scenario;
  const std::int64_t steps = step_count(scenario.dt, scenario.duration);
  const std::string description = scenario.description.empty() ? "" : ": " + scenario.description;
  return scenario.name + description + "\ndt " + short_number_text(scenario.dt, 6) + " s, " +
         number_text(steps) + (steps == 1 ? " step, " : " steps, ") + comparison.precision +
         "-precision Bullet, polhode " + kVersion + "\n" +
         (comparison.note.empty() ? "" : comparison.note + "\n") + "\n";
}

}  // namespace

std::string aligned_columns(const std::vector<Row>& rows, Align align) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - row[i].size(), ' ');
      line += (i == 0 ? "" : "  ") + (i == 0 || align == Align::left ? row[i] + padding : padding + row[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string comparison_table(const Comparison& comparison) {
  std::vector<Row> rows = {{"contender", "final", "worst", "worst", "turn of", "attitude", "attitude",
                            "final", "fast", "diverged", "ns per"},
                           {"", "E/E0-1", "|E/E0-1|", "|L| error", "L, rad", "end, rad", "max, rad", "det R",
                            "steps", "at t, s", "step"}};
  for (const ContenderFigures& contender : comparison.contenders) rows.push_back(figures_row(contender));
  return heading(comparison) + aligned_columns(rows, Align::right);
}

}  // namespace polhode::demos
