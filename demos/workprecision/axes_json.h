#pragma once

#include <nlohmann/json.hpp>

#include "workprecision/axes.h"

namespace polhode::demos {

/// Returns [from, to, count].
template <class Axis>
nlohmann::ordered_json axis_json(const Axis& axis) {
  return {axis.from, axis.to, axis.count};
}

template <class Axis>
nlohmann::ordered_json axis_values_json(const Axis& axis) {
  nlohmann::ordered_json values = nlohmann::ordered_json::array();
  for (std::int64_t i = 0; i < axis.count; ++i) values.push_back(axis.at(i));
  return values;
}

}  // namespace polhode::demos
