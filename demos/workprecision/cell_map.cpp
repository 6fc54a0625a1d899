#include "workprecision/cell_map.h"

#include <nlohmann/json.hpp>

#include "scenario/build_info.h"
#include "workprecision/axes_json.h"
#include "world/run.h"

namespace polhode::demos {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json CellMap::description_start(const std::string& journal) const {
  Json json = {{"journal", journal}, {"polhode_version", kVersion}, {"precision", bullet_precision()}};
  for (const Contender& contender : contenders) json["contenders"].push_back(contender.name);
  return json;
}

Json CellMap::cells_json(const std::vector<CellResult>& results) const {
  Json map = Json::parse(description());
  map.erase("journal");
  map["omega_dt"] = axis_values_json(omega_dt);
  map["inertia_ratio"] = axis_values_json(inertia_ratio);
  Json list;
  for (const Contender& contender : contenders) list.push_back({{"name", contender.name}});
  for (const CellResult& result : results) {
    Json& contender = list[static_cast<std::size_t>(result.index / cells_of_each())];
    const Json figures = figures_json(result);
    for (const auto& [key, figure] : figures.items()) contender[key].push_back(figure);
    contender["diverged_at_step"].push_back(diverged(result) ? Json(result.diverged_step) : Json(nullptr));
  }
  map["contenders"] = list;
  return map;
}

}  // namespace polhode::demos
