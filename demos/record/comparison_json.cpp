#include "record/comparison_json.h"

#include "record/optional_number.h"
#include "scenario/build_info.h"
#include "scenario/scenario_writer.h"

namespace polhode::demos {

using Json = nlohmann::ordered_json;

Json figures_json(const Figures& figures) {
  return {{"steps", figures.steps},
          {"final_energy_error", json_value(figures.final_energy_error)},
          {"worst_energy_error", json_value(figures.worst_energy_error)},
          {"worst_momentum_error", json_value(figures.worst_momentum_error)},
          {"worst_momentum_angle_rad", json_value(figures.worst_momentum_angle_rad)},
          {"final_attitude_error_rad", json_value(figures.final_attitude_error_rad)},
          {"worst_attitude_error_rad", json_value(figures.worst_attitude_error_rad)},
          {"final_det_R", figures.final_det_R},
          {"steps_past_cut", figures.steps_past_cut},
          {"diverged_at_s", json_value(figures.diverged_at_s)},
          {"ns_per_step", figures.ns_per_step}};
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
