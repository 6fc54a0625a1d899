#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "record/figures.h"

/// The figures of a run. The table, the JSON and the report are made from this one list.
namespace polhode::demos {

struct FigureColumn {
  const char* key;      ///< in the JSON
  const char* heading;  ///< in the table: two lines; empty: not in the table
  int digits;           ///< significant ones in the table; 0: a whole number, rounded down
  std::variant<std::int64_t Figures::*, double Figures::*, std::optional<double> Figures::*> member;
  const char* meaning;
  bool has_sign = false;  ///< in the table a + before what is above 0

  bool is_in_table() const { return *heading != '\0'; }
  /// Returns null where there is no such figure.
  nlohmann::ordered_json value(const Figures& figures) const;
  /// Returns the value as in the table, "-" where there is none.
  std::string cell(const Figures& figures) const;
};

/// Returns all figures, in the order of JSON and table.
const std::vector<FigureColumn>& figure_columns();

}  // namespace polhode::demos
