// Measures the library's cost relative to plain Bullet. Built once for each of Bullet's precisions.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "benchmark/heap_count.h"
#include "benchmark/registration.h"
#include "benchmark/summary_reporter.h"
#include "command_line/program.h"

namespace {

using namespace polhode::benchmarks;

constexpr char kSummary[] = "--summary";

void print_help() {
  polhode::demos::print(
      "polhode_benchmark: measures the library's cost relative to plain Bullet.\n"
      "  [--summary]  runs the benchmarks that have a target and prints a table of targets and results;\n"
      "               the exit code does not depend on the results\n"
      "Google Benchmark's options follow. --benchmark_min_time has no effect: the rounds are fixed.\n\n");
  benchmark::PrintDefaultHelp();
}

// Removes the option, which Google Benchmark does not know.
bool take_summary(int& argument_count, char** arguments) {
  char** const end = arguments + argument_count;
  char** const kept = std::remove_if(
      arguments, end, [](const char* argument) { return std::strcmp(argument, kSummary) == 0; });
  argument_count = static_cast<int>(kept - arguments);
  return kept != end;
}

std::size_t run_summary() {
  SummaryReporter reporter(targets());
  const std::string chosen = benchmark::GetBenchmarkFilter();
  return benchmark::RunSpecifiedBenchmarks(&reporter, chosen.empty() ? benchmarks_of(targets()) : chosen);
}

void work(int argument_count, char** arguments) {
  count_heap_of_bullet();
  const bool summary = take_summary(argument_count, arguments);
  benchmark::Initialize(&argument_count, arguments, print_help);
  if (benchmark::ReportUnrecognizedArguments(argument_count, arguments)) {
    throw std::invalid_argument("--help lists the valid options");
  }
  benchmark::AddCustomContext("build", build_text());
  register_benchmarks();
  const std::size_t matched = summary ? run_summary() : benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  if (matched == 0)
    throw std::invalid_argument("no benchmark matches: --benchmark_list_tests lists all benchmarks");
}

}  // namespace

int main(int argument_count, char** arguments) {
  return polhode::demos::run_program(argument_count > 0 ? arguments[0] : "polhode_benchmark",
                                     [&] { work(argument_count, arguments); });
}
