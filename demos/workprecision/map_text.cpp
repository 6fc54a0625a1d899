#include "workprecision/map_text.h"

#include <algorithm>

#include "record/optional_number.h"
#include "record/table.h"

namespace polhode::demos {

namespace {

using Json = nlohmann::ordered_json;

Json values(const LogarithmicAxis& axis) {
  Json list = Json::array();
  for (std::int64_t i = 0; i < axis.count; ++i) list.push_back(axis.at(i));
  return list;
}

}  // namespace

std::string map_csv(const MapGrid& grid, const std::vector<CellResult>& results) {
  std::string text = "contender,omega_dt_rad,inertia_ratio,state,worst_energy_error,diverged_at_step\n";
  for (const CellResult& result : results) {
    const MapCell cell = cell_at(grid, result.index);
    const bool diverged = result.diverged_step > 0;
    text += grid.contenders[cell.contender].name + "," + full_number_text(cell.omega_dt) + "," +
            full_number_text(cell.inertia_ratio) + "," + (diverged ? "diverged" : "finite") + "," +
            full_number_text(result.worst_energy_error) + "," +
            (diverged ? number_text(result.diverged_step) : "") + "\n";
  }
  return text;
}

std::string map_json(const MapGrid& grid, const std::vector<CellResult>& results) {
  Json json = Json::parse(description(grid));
  json.erase("journal");
  json["dt_s"] = kMapTimeStep;
  json["omega_dt"] = values(grid.omega_dt);
  json["inertia_ratio"] = values(grid.inertia_ratio);
  Json contenders = Json::array();
  for (const Contender& contender : grid.contenders) {
    contenders.push_back({{"name", contender.name},
                          {"worst_energy_error", Json::array()},
                          {"diverged_at_step", Json::array()}});
  }
  for (const CellResult& result : results) {
    Json& contender = contenders[cell_at(grid, result.index).contender];
    contender["worst_energy_error"].push_back(result.worst_energy_error);
    contender["diverged_at_step"].push_back(result.diverged_step > 0 ? Json(result.diverged_step)
                                                                     : Json(nullptr));
  }
  json["contenders"] = contenders;
  return json.dump() + "\n";
}

std::string map_summary(const MapGrid& grid, const std::vector<CellResult>& results) {
  std::vector<std::vector<std::string>> rows = {
      {"contender", "cells", "diverged", "median worst |E/E0-1|", "greatest"}};
  const std::size_t cells = results.size() / grid.contenders.size();
  for (std::size_t i = 0; i < grid.contenders.size(); ++i) {
    const auto begin = results.begin() + static_cast<std::ptrdiff_t>(i * cells);
    std::vector<double> errors;
    std::int64_t diverged = 0;
    for (auto result = begin; result != begin + static_cast<std::ptrdiff_t>(cells); ++result) {
      errors.push_back(result->worst_energy_error);
      if (result->diverged_step > 0) ++diverged;
    }
    std::sort(errors.begin(), errors.end());
    rows.push_back({grid.contenders[i].name, number_text(static_cast<std::int64_t>(cells)),
                    number_text(diverged), short_number_text(errors[cells / 2], 3),
                    short_number_text(errors.back(), 3)});
  }
  return aligned_columns(rows, Align::right);
}

}  // namespace polhode::demos
