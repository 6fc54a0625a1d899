#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "record/figures.h"

namespace polhode::demos {

/// Returns the figures of a run as the document has them.
nlohmann::ordered_json figures_json(const Figures& figures);

/// Returns the comparison as a JSON document; docs/compare.md documents its keys.
std::string comparison_json(const Comparison& comparison);

}  // namespace polhode::demos
