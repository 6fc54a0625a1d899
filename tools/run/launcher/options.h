#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polhode::run {

struct Options {
  std::string scheme;
  std::string summary;               ///< value of kSummaryVariable, see settings.h
  std::vector<std::string> program;  ///< name and arguments
};

/// Returns nothing after printing --help or --version.
/// @throws std::invalid_argument for invalid options; the message says what is wrong and what is valid.
std::optional<Options> parse_options(int argument_count, char** arguments);

}  // namespace polhode::run
