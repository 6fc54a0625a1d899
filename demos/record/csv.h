#pragma once

#include <string>

#include "record/quantities.h"

/// The rows of a record as CSV; docs/compare.md documents the columns.
namespace polhode::demos {

/// The first line, newline included.
std::string csv_header();

/// Returns one line, newline included, with 17 significant digits.
std::string csv_row(const std::string& contender, const Instant& at);

}  // namespace polhode::demos
