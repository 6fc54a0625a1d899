#pragma once

#include <string>

#include "workprecision/curve.h"

/// Return a curve as text; docs/work_precision.md documents columns and keys.
namespace polhode::demos {

std::string curve_table(const Curve& curve);
std::string curve_csv(const Curve& curve);
std::string curve_json(const Curve& curve);

}  // namespace polhode::demos
