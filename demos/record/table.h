#pragma once

#include <string>
#include <vector>

#include "record/figures.h"

namespace polhode::demos {

/// Returns the comparison as text: a heading, then an aligned table with a row per contender. "-" means not
/// applicable.
std::string comparison_table(const Comparison& comparison);

enum class Align { left, right };

/// Pads columns to the widest cell, the first one left-aligned, the others as `align` says. Each row ends in
/// a newline.
std::string aligned_columns(const std::vector<std::vector<std::string>>& rows, Align align);

}  // namespace polhode::demos
