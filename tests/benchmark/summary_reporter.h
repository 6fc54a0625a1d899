#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "benchmark/targets.h"

namespace polhode::benchmarks {

/// Returns a line that says which builds are measured.
std::string build_text();

/// Holds the benchmarks against the targets: a table when all have run, for people.
class SummaryReporter final : public benchmark::BenchmarkReporter {
 public:
  explicit SummaryReporter(std::vector<Target> targets) : targets_(std::move(targets)) {}

  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  std::vector<std::string> row(const Target& target) const;

  std::vector<Target> targets_;
  std::map<std::string, benchmark::UserCounters> counters_of_;  ///< by the benchmark's name
};

}  // namespace polhode::benchmarks
