#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "record/figures.h"

/// The figures of a run. Table, JSON and report are made from this list.
namespace polhode::demos {

struct FigureColumn {
  const char* key;      ///< in the JSON
  const char* heading;  ///< two lines of the table; empty if not in the table
  int digits;           ///< significant digits in the table; 0 for a whole number, rounded down
  std::variant<std::int64_t Figures::*, double Figures::*, std::optional<double> Figures::*> member;
  const char* meaning;
  bool has_sign = false;  ///< the table shows a + before positive values

  bool is_in_table() const { return *heading != '\0'; }
  /// Returns null if the run has no such figure.
  nlohmann::ordered_json value(const Figures& figures) const;
  /// Returns the value as in the table, "-" if there is none.
  std::string cell(const Figures& figures) const;
};

/// Returns all figures, in the order of JSON and table.
const std::vector<FigureColumn>& figure_columns();

}  // namespace polhode::demos
