#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "benchmark/targets.h"

namespace polhode::benchmarks {

/// Returns a line that describes the measured build.
std::string build_text();

/// Compares the results with the targets and prints a table after all benchmarks have run.
class SummaryReporter final : public benchmark::BenchmarkReporter {
 public:
  explicit SummaryReporter(std::vector<Target> targets) : targets_(std::move(targets)) {}

  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  std::vector<std::string> row(const Target& target) const;

  std::vector<Target> targets_;
  std::map<std::string, benchmark::UserCounters> counters_of_;  ///< key: name of the benchmark
};

}  // namespace polhode::benchmarks
