#pragma once

#include "compare/options.h"
#include "record/figures.h"

namespace polhode::demos {

/// Runs the comparison that the options describe and writes its files.
/// @throws std::exception that says what is wrong and what is valid; no file is written then
Comparison compare(const Options& options);

/// Lists scenarios and contenders, one per line.
std::string list_text();

}  // namespace polhode::demos
