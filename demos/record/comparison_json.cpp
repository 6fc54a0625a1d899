#include "record/comparison_json.h"

#include "record/figure_columns.h"
#include "scenario/build_info.h"
#include "scenario/scenario_writer.h"

namespace polhode::demos {

using Json = nlohmann::ordered_json;

Json figures_json(const Figures& figures) {
  Json json;
  for (const FigureColumn& column : figure_columns()) json[column.key] = column.value(figures);
  return json;
}

std::string comparison_json(const Comparison& comparison) {
  Json json;
  json["polhode_version"] = kVersion;
  json["precision"] = comparison.precision;
  json["scenario"] = scenario_json(comparison.scenario);
  json["contenders"] = Json::array();
  for (const ContenderFigures& contender : comparison.contenders) {
    Json& entry = json["contenders"].emplace_back(Json{{"name", contender.contender}});
    entry.update(figures_json(contender.figures));
  }
  return json.dump(2) + "\n";
}

}  // namespace polhode::demos
