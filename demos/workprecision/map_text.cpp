#include <algorithm>

#include "record/optional_number.h"
#include "record/table.h"
#include "workprecision/axes_json.h"
#include "workprecision/map_grid.h"

namespace polhode::demos {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string MapGrid::csv(const std::vector<CellResult>& results) const {
  std::string text = "contender,omega_dt_rad,inertia_ratio,state,worst_energy_error,diverged_at_step\n";
  for (const CellResult& result : results) {
    const MapCell cell = cell_at(*this, result.index);
    const bool diverged = result.diverged_step > 0;
    text += contenders[cell.contender].name + "," + full_number_text(cell.omega_dt) + "," +
            full_number_text(cell.inertia_ratio) + "," + (diverged ? "diverged" : "finite") + "," +
            full_number_text(result.figures[0]) + "," + (diverged ? number_text(result.diverged_step) : "") +
            "\n";
  }
  return text;
}

std::string MapGrid::json(const std::vector<CellResult>& results) const {
  Json map = Json::parse(description());
  map.erase("journal");
  map["dt_s"] = kMapTimeStep;
  map["omega_dt"] = axis_values_json(omega_dt);
  map["inertia_ratio"] = axis_values_json(inertia_ratio);
  Json list = Json::array();
  for (const Contender& contender : contenders) {
    list.push_back({{"name", contender.name},
                    {"worst_energy_error", Json::array()},
                    {"diverged_at_step", Json::array()}});
  }
  for (const CellResult& result : results) {
    Json& contender = list[cell_at(*this, result.index).contender];
    contender["worst_energy_error"].push_back(result.figures[0]);
    contender["diverged_at_step"].push_back(result.diverged_step > 0 ? Json(result.diverged_step)
                                                                     : Json(nullptr));
  }
  map["contenders"] = list;
  return map.dump() + "\n";
}

std::string MapGrid::summary(const std::vector<CellResult>& results) const {
  std::vector<std::vector<std::string>> rows = {
      {"contender", "cells", "diverged", "median worst |E/E0-1|", "greatest"}};
  const std::size_t cells = results.size() / contenders.size();
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const auto begin = results.begin() + static_cast<std::ptrdiff_t>(i * cells);
    std::vector<double> errors;
    std::int64_t diverged = 0;
    for (auto result = begin; result != begin + static_cast<std::ptrdiff_t>(cells); ++result) {
      errors.push_back(result->figures[0]);
      if (result->diverged_step > 0) ++diverged;
    }
    std::sort(errors.begin(), errors.end());
    rows.push_back({contenders[i].name, number_text(static_cast<std::int64_t>(cells)), number_text(diverged),
                    short_number_text(errors[cells / 2], 3), short_number_text(errors.back(), 3)});
  }
  return aligned_columns(rows, Align::right);
}

}  // namespace polhode::demos
