#include "workprecision/curve_text.h"

#include "record/optional_number.h"
#include "record/table.h"
#include "scenario/build_info.h"
#include "world/run.h"

namespace polhode::demos {

namespace {

using Json = nlohmann::ordered_json;

std::optional<double> ns_per_step(const CurvePoint& point) {
  return point.cost ? std::optional(point.cost->ns_per_step) : std::nullopt;
}

std::optional<double> ratio(const CurvePoint& point) {
  return point.cost ? std::optional(point.cost->ratio) : std::nullopt;
}

std::vector<std::string> table_row(const CurvePoint& point) {
  return {point.contender,
          short_number_text(point.dt_s, 4),
          table_cell(point.attitude_error_rad, 3),
          table_cell(point.observed_order, 3),
          point.declared_order,
          short_number_text(point.worst_energy_error, 3),
          table_cell(point.diverged_at_s, 4),
          table_cell(ns_per_step(point), 4),
          table_cell(point.ns_per_simulated_second(), 4),
          table_cell(ratio(point), 3)};
}

std::string csv_row(const CurvePoint& point) {
  std::string row = point.contender + "," + point.declared_order + "," + full_number_text(point.dt_s) + "," +
                    number_text(point.steps) + "," + full_number_text(point.worst_energy_error);
  for (const std::optional<double>& value :
       {point.diverged_at_s, point.attitude_error_rad, point.observed_order, ns_per_step(point),
        point.ns_per_simulated_second(), ratio(point)}) {
    row += "," + csv_cell(value);
  }
  return row + "\n";
}

Json point_json(const CurvePoint& point) {
  return {{"contender", point.contender},
          {"declared_order", point.declared_order},
          {"dt_s", point.dt_s},
          {"steps", point.steps},
          {"worst_energy_error", point.worst_energy_error},
          {"diverged_at_s", json_value(point.diverged_at_s)},
          {"attitude_error_rad", json_value(point.attitude_error_rad)},
          {"observed_order", json_value(point.observed_order)},
          {"ns_per_step", json_value(ns_per_step(point))},
          {"ns_per_simulated_second", json_value(point.ns_per_simulated_second())},
          {"ratio_to_implicit_body", json_value(ratio(point))}};
}

}  // namespace

std::string curve_table(const Curve& curve) {
  std::vector<std::vector<std::string>> rows = {
      {"contender", "dt", "attitude", "order", "order", "worst", "diverged", "ns per", "ns per", "ratio to"},
      {"", "s", "error, rad", "seen", "declared", "|E/E0-1|", "at t, s", "step", "simulated s",
       "implicit_body"}};
  for (const CurvePoint& point : curve.points) rows.push_back(table_row(point));
  return "a free body after " + short_number_text(curve.time_s, 6) + " s, " + bullet_precision() +
         "-precision Bullet, polhode " + kVersion + "\n\n" + aligned_columns(rows, Align::right);
}

std::string curve_csv(const Curve& curve) {
  std::string text =
      "contender,declared_order,dt_s,steps,worst_energy_error,diverged_at_s,attitude_error_rad,"
      "observed_order,ns_per_step,ns_per_simulated_second,ratio_to_implicit_body\n";
  for (const CurvePoint& point : curve.points) text += csv_row(point);
  return text;
}

std::string curve_json(const Curve& curve) {
  const FreeBody& body = curve.body;
  Json json;
  json["polhode_version"] = kVersion;
  json["precision"] = bullet_precision();
  json["inertia"] = {body.inertia_B.x(), body.inertia_B.y(), body.inertia_B.z()};
  json["orientation"] = {body.q_WB.w(), body.q_WB.x(), body.q_WB.y(), body.q_WB.z()};
  json["angular_velocity"] = {body.omega_W.x(), body.omega_W.y(), body.omega_W.z()};
  json["time_s"] = curve.time_s;
  json["points"] = Json::array();
  for (const CurvePoint& point : curve.points) json["points"].push_back(point_json(point));
  return json.dump(2) + "\n";
}

}  // namespace polhode::demos
