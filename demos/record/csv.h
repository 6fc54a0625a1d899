#pragma once

#include <string>

#include "record/quantities.h"

/// Writes the rows of a record as CSV; docs/compare.md documents the columns.
namespace polhode::demos {

/// Returns the first line, including the newline.
std::string csv_header();

/// Returns one line, including the newline, with 17 significant digits.
std::string csv_row(const std::string& contender, const Instant& at);

}  // namespace polhode::demos
