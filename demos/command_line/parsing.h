#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenario/range.h"

/// Shared parts of the programs' command lines.
namespace polhode::demos {

/// Returns false if --help or --version was given, and has been printed.
/// @throws std::invalid_argument that says what is wrong and which options, or subcommands, are valid
bool parse(CLI::App& app, int argument_count, char** arguments);

/// Adds --scheme-library, repeatable. Its schemes are registered while the command line is parsed.
void add_scheme_library_option(CLI::App& app);

/// Returns an option's number. CLI11 would read numbers as the locale writes them.
/// @throws std::invalid_argument
double option_number(const std::string& option, const std::string& text, const Range& range);
std::int64_t option_whole_number(const std::string& option, const std::string& text, const Range& range);

struct OutputOption {
  std::string option;
  std::optional<std::filesystem::path> file;
};

/// @throws std::invalid_argument if two of the options name the same file
void check_different_files(const std::vector<OutputOption>& outputs);

/// Returns the command line as one would type it, without the program's directory.
std::string command_line(int argument_count, char** arguments);

}  // namespace polhode::demos
