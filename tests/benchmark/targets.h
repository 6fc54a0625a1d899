#pragma once

#include <optional>
#include <string>
#include <vector>

namespace polhode::benchmarks {

/// A row of the summary: a quantity and its largest allowed value.
struct Target {
  std::string what;
  std::string benchmark;  ///< name, or a regular expression for several, of which the largest value counts
  std::string counter;
  std::optional<double> at_most;  ///< none: a control, which shows the uncertainty of the other rows
};

std::vector<Target> targets();

/// Returns the regular expression for the benchmarks that the targets need.
std::string benchmarks_of(const std::vector<Target>& targets);

}  // namespace polhode::benchmarks
