#pragma once

#include "compare/options.h"
#include "record/figures.h"

namespace polhode::demos {

/// Does what the options say: reads the scenario, runs the contenders, writes the CSV and JSON files.
/// @throws std::exception that says what is wrong and what is valid; then no file was written.
Comparison compare(const Options& options);

/// Scenarios and contenders, a line each.
std::string list_text();

}  // namespace polhode::demos
