#pragma once

#include <optional>
#include <string>
#include <vector>

namespace polhode::benchmarks {

/// A row of the summary: what is measured and how little it should be.
struct Target {
  std::string what;
  std::string
      benchmark;  ///< its name, or a regular expression for several, of which the greatest figure counts
  std::string counter;
  std::optional<double> at_most;  ///< none: shown to say what the others are worth
};

std::vector<Target> targets();

/// The regular expression for the benchmarks that the targets need.
std::string benchmarks_of(const std::vector<Target>& targets);

}  // namespace polhode::benchmarks
