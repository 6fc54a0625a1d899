#include "record/table.h"

#include <algorithm>

#include "record/figure_columns.h"
#include "scenario/build_info.h"
#include "scenario/number_text.h"

namespace polhode::demos {

namespace {

using Row = std::vector<std::string>;

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
  std::vector<Row> rows = {{"contender"}, {""}};
  for (const ContenderFigures& contender : comparison.contenders) rows.push_back({contender.contender});
  for (const FigureColumn& column : figure_columns()) {
    if (!column.is_in_table()) continue;
    const std::string heading = column.heading;
    const std::size_t line_end = heading.find('\n');
    rows[0].push_back(heading.substr(0, line_end));
    rows[1].push_back(heading.substr(line_end + 1));
    for (std::size_t i = 0; i < comparison.contenders.size(); ++i) {
      rows[i + 2].push_back(column.cell(comparison.contenders[i].figures));
    }
  }
  return heading(comparison) + aligned_columns(rows, Align::right);
}

}  // namespace polhode::demos
