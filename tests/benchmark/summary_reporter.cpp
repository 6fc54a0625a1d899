#include "benchmark/summary_reporter.h"

#include <LinearMath/btScalar.h>

#include <cmath>
#include <regex>

#include "benchmark/paired_times.h"
#include "record/table.h"
#include "scenario/build_info.h"
#include "scenario/number_text.h"

namespace polhode::benchmarks {

namespace {

using benchmark::UserCounters;

constexpr int kDigits = 3;

std::string number_cell(double value) {
  if (value >= 100.0) return demos::number_text(static_cast<std::int64_t>(std::llround(value)));
  return demos::short_number_text(value, kDigits);
}

std::string cell(const UserCounters& counters, const std::string& name) {
  const auto found = counters.find(name);
  return found == counters.end() ? "-" : number_cell(found->second.value);
}

std::string spread(const UserCounters& counters) {
  return cell(counters, counters::kRatioQuartile1) + " to " + cell(counters, counters::kRatioQuartile3);
}

std::string verdict(double measured, const std::optional<double>& at_most) {
  if (!at_most) return "";
  return measured <= *at_most ? "met" : "missed";
}

// btGetVersion() returns 324 for version 3.24.
std::string bullet_version() {
  const int version = btGetVersion();
  return std::to_string(version / 100) + "." + std::to_string(version % 100);
}

}  // namespace

std::string build_text() {
  const std::string precision = sizeof(btScalar) == sizeof(double) ? "double" : "single";
  return std::string("polhode ") + demos::kVersion + ", " + precision + "-precision Bullet " +
         bullet_version() + ", " POLHODE_COMPILER ", " POLHODE_BUILD_TYPE;
}

bool SummaryReporter::ReportContext(const Context& context) {
  GetOutputStream() << build_text() << ", " << context.cpu_info.num_cpus << " CPUs\n" << std::flush;
  return true;
}

void SummaryReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration) continue;
    GetErrorStream() << "measured " << run.run_name.function_name << std::endl;
    counters_of_[run.run_name.function_name] = run.counters;
  }
}

void SummaryReporter::Finalize() {
  std::vector<std::vector<std::string>> rows = {
      {"", "target", "measured", "middle half", "Bullet,", "Polhode,", ""},
      {"", "at most", "(median)", "of the rounds", "ns/body/step", "ns/body/step", ""}};
  for (const Target& target : targets_) rows.push_back(row(target));
  GetOutputStream() << "A ratio is the time with Polhode / the time of plain Bullet.\n\n"
                    << demos::aligned_columns(rows, demos::Align::right) << std::flush;
}

std::vector<std::string> SummaryReporter::row(const Target& target) const {
  const std::regex name(target.benchmark);
  const UserCounters* worst = nullptr;
  for (const auto& [benchmark_name, counters] : counters_of_) {
    if (!std::regex_match(benchmark_name, name)) continue;
    if (worst == nullptr || counters.at(target.counter) > worst->at(target.counter)) worst = &counters;
  }
  const std::string at_most = target.at_most ? number_cell(*target.at_most) : "-";
  if (worst == nullptr) return {target.what, at_most, "not measured"};
  const double measured = worst->at(target.counter);
  std::vector<std::string> cells = {target.what, at_most, cell(*worst, target.counter)};
  const bool is_ratio = target.counter == counters::kRatio;
  cells.push_back(is_ratio ? spread(*worst) : "");
  cells.push_back(is_ratio ? cell(*worst, counters::kPlainNs) : "");
  cells.push_back(is_ratio ? cell(*worst, counters::kPolhodeNs) : "");
  cells.push_back(verdict(measured, target.at_most));
  return cells;
}

}  // namespace polhode::benchmarks
