#include "report/report.h"

#include <algorithm>

#include "record/comparison_json.h"
#include "record/figure_columns.h"
#include "record/quantities.h"
#include "report/base64.h"
#include "report/page_template.h"
#include "scenario/build_info.h"
#include "scenario/scenario_writer.h"

namespace polhode::demos {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kDataMarker = "@REPORT_DATA@";

Json list(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}

Json body_json(const DrawnBody& body) {
  if (body.radius) return {{"radius", *body.radius}};
  Json parts = Json::array();
  for (const DrawnBox& box : body.boxes) {
    parts.push_back({{"half_extents", list(box.half_extents)},
                     {"at", list(box.at_B)},
                     {"q", {box.q_BP.w(), box.q_BP.x(), box.q_BP.y(), box.q_BP.z()}}});
  }
  return {{"parts", parts}};
}

Json components_json() {
  Json json;
  for (const Quantity& quantity : quantities()) {
    if (quantity.is_in_report()) json[quantity.key] = quantity.components;
  }
  return json;
}

Json plots_json() {
  Json json = Json::array();
  for (const Quantity* quantity : plotted_quantities()) {
    json.push_back({{"key", quantity->key},
                    {"label", quantity->label},
                    {"unit", quantity->unit},
                    {"meaning", quantity->meaning},
                    {"is_logarithmic", quantity->drawing == Drawing::logarithmic},
                    {"is_adaptive", quantity->drawing == Drawing::adaptive}});
  }
  return json;
}

Json columns_json() {
  Json json = Json::array();
  for (const FigureColumn& column : figure_columns()) {
    if (column.is_in_table()) json.push_back({{"heading", column.heading}, {"meaning", column.meaning}});
  }
  return json;
}

Json cells_json(const Figures& figures) {
  Json json = Json::array();
  for (const FigureColumn& column : figure_columns()) {
    if (column.is_in_table()) json.push_back(column.cell(figures));
  }
  return json;
}

// Leaves out quantities that are always 0, such as the momentum of absent rotors.
Json series_json(const Series& series) {
  Json json = {{"count", series.records()}, {"stride", series.stride}, {"past_cut", base64(series.past_cut)}};
  for (const auto& [key, numbers] : series.columns) {
    const bool is_zero =
        std::all_of(numbers.begin(), numbers.end(), [](float number) { return number == 0.0F; });
    if (!is_zero) json[std::string(key)] = base64(numbers);
  }
  return json;
}

// Escapes the JSON, so that no text in it can end the script element around it.
std::string without_tags(const std::string& json) {
  std::string result;
  for (const char c : json) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::size_t most_records(std::size_t contenders) {
  constexpr std::size_t kMostInAll = 6500;  // of some 160 bytes each
  constexpr std::size_t kMost = 1000;       // more than a screen has columns
  return std::min(kMost, kMostInAll / std::max<std::size_t>(1, contenders));
}

std::string report_json(const Report& report) {
  const Comparison& comparison = report.comparison;
  const Scenario& scenario = comparison.scenario;
  Json json;
  json["polhode_version"] = kVersion;
  json["precision"] = comparison.precision;
  json["command"] = report.command;
  json["scenario"] = scenario_json(scenario);
  json["inertia_B"] = list(scenario.body.inertia_B.value());
  json["body"] = body_json(report.body);
  if (scenario.ground) {
    json["ground"] = {{"height", scenario.ground->height}, {"normal", list(scenario.ground->normal_W)}};
  }
  json["steps"] = step_count(scenario.dt, scenario.duration);
  if (!comparison.note.empty()) json["note"] = comparison.note;
  json["components"] = components_json();
  json["plots"] = plots_json();
  json["columns"] = columns_json();
  json["contenders"] = Json::array();
  for (std::size_t i = 0; i < comparison.contenders.size(); ++i) {
    json["contenders"].push_back({{"name", comparison.contenders[i].contender},
                                  {"summary", report.summaries[i]},
                                  {"figures", figures_json(comparison.contenders[i].figures)},
                                  {"cells", cells_json(comparison.contenders[i].figures)},
                                  {"series", series_json(report.series[i])}});
  }
  return json.dump();
}

std::string report_html(const Report& report) {
  const std::string_view page = page_template();
  const std::size_t marker = page.find(kDataMarker);
  std::string html(page.substr(0, marker));
  html += without_tags(report_json(report));
  html += page.substr(marker + kDataMarker.size());
  return html;
}

}  // namespace polhode::demos
