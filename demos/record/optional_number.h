#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "scenario/number_text.h"

/// Cells of tables, CSV and JSON that may be empty.
namespace polhode::demos {

inline std::string table_cell(const std::optional<double>& value, int digits) {
  return value ? short_number_text(*value, digits) : "-";
}

inline std::string csv_cell(const std::optional<double>& value) {
  return value ? full_number_text(*value) : "";
}

inline nlohmann::ordered_json json_value(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace polhode::demos
