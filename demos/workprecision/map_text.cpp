#include <algorithm>

#include "record/optional_number.h"
#include "record/table.h"
#include "workprecision/map_grid.h"

namespace polhode::demos {

std::string MapGrid::csv(const std::vector<CellResult>& results) const {
  std::string text = "contender,omega_dt_rad,inertia_ratio,state,worst_energy_error,diverged_at_step\n";
  for (const CellResult& result : results) {
    const MapCell cell = cell_at(*this, result.index);
    text += contenders[cell.contender].name + "," + full_number_text(cell.omega_dt) + "," +
            full_number_text(cell.inertia_ratio) + "," + (diverged(result) ? "diverged" : "finite") + "," +
            full_number_text(result.figures[0]) + "," +
            (diverged(result) ? number_text(result.diverged_step) : "") + "\n";
  }
  return text;
}

std::string MapGrid::json(const std::vector<CellResult>& results) const {
  nlohmann::ordered_json map = cells_json(results);
  map["dt_s"] = kMapTimeStep;
  return map.dump() + "\n";
}

nlohmann::ordered_json MapGrid::figures_json(const CellResult& result) const {
  return {{"worst_energy_error", result.figures[0]}};
}

std::string MapGrid::summary(const std::vector<CellResult>& results) const {
  std::vector<std::vector<std::string>> rows = {
      {"contender", "cells", "diverged", "median worst |E/E0-1|", "greatest"}};
  const std::size_t cells = static_cast<std::size_t>(cells_of_each());
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const auto begin = results.begin() + static_cast<std::ptrdiff_t>(i * cells);
    std::vector<double> errors;
    std::int64_t diverged_cells = 0;
    for (auto result = begin; result != begin + static_cast<std::ptrdiff_t>(cells); ++result) {
      errors.push_back(result->figures[0]);
      if (diverged(*result)) ++diverged_cells;
    }
    std::sort(errors.begin(), errors.end());
    rows.push_back({contenders[i].name, number_text(static_cast<std::int64_t>(cells)),
                    number_text(diverged_cells), short_number_text(errors[cells / 2], 3),
                    short_number_text(errors.back(), 3)});
  }
  return aligned_columns(rows, Align::right);
}

}  // namespace polhode::demos
