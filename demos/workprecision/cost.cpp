#include "workprecision/cost.h"

#include "record/optional_number.h"
#include "record/table.h"
#include "scenario/build_info.h"
#include "workprecision/motion.h"
#include "workprecision/output_files.h"
#include "world/run.h"

namespace polhode::demos {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kStepsAtMost = 1000;

// Owns the kernels that the laps point to.
class Laps {
 public:
  explicit Laps(const CostOptions& options) : options_(options) {
    const Contender baseline = find_contenders({kBaseline}).front();
    add(baseline, Kick::none, 0);
    add(baseline, Kick::every_step, 1);
    for (const Contender& contender : options.contenders) {
      add(contender, Kick::none, 0);
      add(contender, Kick::every_step, 1);
    }
  }

  const std::vector<Lap>& laps() const { return laps_; }

 private:
  void add(const Contender& contender, Kick kick, std::size_t baseline) {
    kernels_.push_back(make_kernel(contender, options_.body, options_.dt_s, kick));
    laps_.push_back({kernels_.back().get(), follow(*kernels_.back(), kStepsAtMost).steps, baseline});
  }

  const CostOptions& options_;
  std::vector<std::unique_ptr<Kernel>> kernels_;
  std::vector<Lap> laps_;
};

std::optional<double> ns(const std::optional<Cost>& cost) {
  return cost ? std::optional(cost->ns_per_step) : std::nullopt;
}

std::optional<double> ratio(const std::optional<Cost>& cost) {
  return cost ? std::optional(cost->ratio) : std::nullopt;
}

}  // namespace

std::vector<ContenderCost> costs(const CostOptions& options) {
  OutputFiles files(options.outputs.csv, options.outputs.json);
  const Laps laps(options);
  const std::vector<std::optional<Cost>> measured = measure_costs(laps.laps(), options.rounds);
  std::vector<ContenderCost> result;
  for (std::size_t i = 0; i < options.contenders.size(); ++i) {
    result.push_back({options.contenders[i].name, measured[2 * i + 2], measured[2 * i + 3]});
  }
  files.write(cost_csv(result), cost_json(result));
  return result;
}

std::string cost_table(const std::vector<ContenderCost>& costs) {
  std::vector<std::vector<std::string>> rows = {{"contender", "free:", "ratio to", "kicked:", "ratio to"},
                                                {"", "ns/step", "implicit_body", "ns/step", "implicit_body"}};
  for (const ContenderCost& cost : costs) {
    rows.push_back({cost.contender, table_cell(ns(cost.free), 3), table_cell(ratio(cost.free), 3),
                    table_cell(ns(cost.kicked), 3), table_cell(ratio(cost.kicked), 3)});
  }
  return "cost of a step, " + bullet_precision() + "-precision Bullet, polhode " + kVersion + "\n\n" +
         aligned_columns(rows, Align::right);
}

std::string cost_csv(const std::vector<ContenderCost>& costs) {
  std::string text =
      "contender,free_ns_per_step,free_ratio_to_implicit_body,kicked_ns_per_step,"
      "kicked_ratio_to_implicit_body\n";
  for (const ContenderCost& cost : costs) {
    text += cost.contender + "," + csv_cell(ns(cost.free)) + "," + csv_cell(ratio(cost.free)) + "," +
            csv_cell(ns(cost.kicked)) + "," + csv_cell(ratio(cost.kicked)) + "\n";
  }
  return text;
}

std::string cost_json(const std::vector<ContenderCost>& costs) {
  Json json;
  json["polhode_version"] = kVersion;
  json["precision"] = bullet_precision();
  json["contenders"] = Json::array();
  for (const ContenderCost& cost : costs) {
    json["contenders"].push_back({{"name", cost.contender},
                                  {"free_ns_per_step", json_value(ns(cost.free))},
                                  {"free_ratio_to_implicit_body", json_value(ratio(cost.free))},
                                  {"kicked_ns_per_step", json_value(ns(cost.kicked))},
                                  {"kicked_ratio_to_implicit_body", json_value(ratio(cost.kicked))}});
  }
  return json.dump(2) + "\n";
}

}  // namespace polhode::demos
