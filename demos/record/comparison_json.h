#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "record/figures.h"

namespace polhode::demos {

/// A run's figures as they stand in it.
nlohmann::ordered_json figures_json(const Figures& figures);

/// The comparison as a JSON document; docs/compare.md documents its keys.
std::string comparison_json(const Comparison& comparison);

}  // namespace polhode::demos
