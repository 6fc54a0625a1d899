#pragma once

#include <string>
#include <vector>

#include "record/figures.h"

namespace polhode::demos {

/// The comparison as text: a heading, then an aligned table with a row per contender. "-" is not applicable.
std::string comparison_table(const Comparison& comparison);

enum class Align { left, right };

/// Columns padded to the widest cell, the first to the left, the others as `align` says; each row ends in a
/// newline.
std::string aligned_columns(const std::vector<std::vector<std::string>>& rows, Align align);

}  // namespace polhode::demos
