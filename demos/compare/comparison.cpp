#include "compare/comparison.h"

#include "command_line/interruption.h"
#include "command_line/progress_bar.h"
#include "compare/side_by_side.h"
#include "record/comparison_json.h"
#include "record/csv.h"
#include "record/output_file.h"
#include "record/table.h"
#include "scenario/named_error.h"
#include "scenario/printable_text.h"
#include "scenario/scenario_directory.h"
#include "world/body_shape.h"

namespace polhode::demos {

namespace {

Scenario chosen_scenario(const Options& options) {
  Scenario scenario = find_scenario(options.scenario);
  scenario.dt = options.dt.value_or(scenario.dt);
  scenario.duration = options.duration.value_or(scenario.duration);
  return naming_the_scenario(options.scenario, [&] {
    step_count(scenario.dt, scenario.duration);
    return resolved(scenario);
  });
}

// The files that a comparison writes besides the table. They are opened before the run, to fail early, and
// get their names after it.
struct Files {
  std::optional<OutputFile> csv;
  std::optional<OutputFile> json;
  std::optional<OutputFile> report;

  explicit Files(const Options& options) {
    if (options.csv) csv.emplace(*options.csv);
    if (options.json) json.emplace(*options.json);
    if (options.report) report.emplace(*options.report);
    if (csv) csv->write(csv_header());
  }

  void write(const Report& finished) {
    if (json) json->write(comparison_json(finished.comparison));
    if (report) report->write(report_html(finished));
    for (std::optional<OutputFile>* file : {&csv, &json, &report}) {
      if (*file) (*file)->commit();
    }
  }
};

// The report, run with the progress shown and the CSV file written.
Report run_all(const Scenario& scenario, const ChosenContenders& chosen, const std::string& command,
               Files& files) {
  const std::int64_t steps = step_count(scenario.dt, scenario.duration);
  ProgressBar progress(steps * static_cast<std::int64_t>(chosen.contenders.size()));
  Sample start;
  const auto observe = [&](std::size_t contender, const Sample& sample) {
    const std::string& name = chosen.contenders[contender].name;
    throw_if_interrupted();
    progress.show(static_cast<std::int64_t>(contender) * steps + sample.step, name);
    if (sample.step == 0) start = sample;
    if (files.csv) files.csv->write(csv_row(name, {sample, start, *scenario.body.inertia_B}));
  };
  return run_side_by_side(scenario, chosen, command, observe);
}

}  // namespace

Comparison compare(const Options& options) {
  const Scenario scenario = chosen_scenario(options);
  const ChosenContenders chosen = chosen_contenders(options.contenders, scenario);
  Files files(options);
  const Report report = run_all(scenario, chosen, options.command, files);
  files.write(report);
  return report.comparison;
}

std::string list_text() {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& name : scenario_names()) {
    rows.push_back({printable(name), find_scenario(name).description});
  }
  std::string text = "scenarios:\n" + aligned_columns(rows, Align::left);
  rows.clear();
  for (const Contender& contender : all_contenders()) rows.push_back({contender.name, contender.summary});
  return text + "contenders:\n" + aligned_columns(rows, Align::left);
}

}  // namespace polhode::demos
