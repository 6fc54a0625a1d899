#include "record/csv.h"

#include "record/optional_number.h"

namespace polhode::demos {

std::string csv_header() {
  std::string header = "contender";
  for (const Quantity& quantity : quantities()) {
    if (quantity.is_in_csv()) header += std::string(",") + quantity.csv_columns;
  }
  return header + "\n";
}

std::string csv_row(const std::string& contender, const Instant& at) {
  std::string row = contender;
  for (const Quantity& quantity : quantities()) {
    if (!quantity.is_in_csv()) continue;
    for (int i = 0; i < quantity.components; ++i) row += "," + csv_cell(quantity.value(at, i));
  }
  return row + "\n";
}

}  // namespace polhode::demos
