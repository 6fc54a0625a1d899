#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polhode::run {

struct Options {
  std::string scheme;
  /// Where the summary goes, as settings.h has it.
  std::string summary;
  std::vector<std::string> program;  ///< its name and its arguments
};

/// Returns nothing if --help or --version was asked for, and printed.
/// @throws std::invalid_argument that says what is wrong and what is valid.
std::optional<Options> parse_options(int argument_count, char** arguments);

}  // namespace polhode::run
