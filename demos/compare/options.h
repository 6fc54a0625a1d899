#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polhode::demos {

/// Holds the options of polhode_compare's command line.
struct Options {
  bool list = false;
  std::string scenario = "dzhanibekov";
  std::vector<std::string> contenders;  ///< empty for the default ones
  std::optional<double> dt;
  std::optional<double> duration;
  std::optional<std::filesystem::path> csv;
  std::optional<std::filesystem::path> json;
  std::optional<std::filesystem::path> report;
  std::string command;  ///< the whole command line, quoted for a shell
};

/// Returns the options, or nothing if the command line asked for --help or --version, which is then printed.
/// @throws std::invalid_argument that says what is wrong and what is valid
std::optional<Options> parse_options(int argument_count, char** arguments);

}  // namespace polhode::demos
