#pragma once

#include <string>

#include "record/figures.h"

namespace polhode::demos {

/// The comparison as a JSON document; demos/README.md documents its keys.
std::string comparison_json(const Comparison& comparison);

}  // namespace polhode::demos
