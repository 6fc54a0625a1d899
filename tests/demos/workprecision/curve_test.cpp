// Runs polhode_workprecision curve and cost as processes.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "demos/workprecision/tool.h"
#include "polhode/scheme_registry.h"

namespace polhode::demos {
namespace {

using nlohmann::json;

class WorkPrecision : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (directory_ / name).string(); }

  json json_of(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--json", file("out.json")});
    work_precision(arguments);
    return json::parse(read_file(file("out.json")));
  }

  // Returns the point of the smallest time step.
  static json last_point(const json& curve, const std::string& contender) {
    json last;
    for (const json& point : curve["points"]) {
      if (point["contender"] == contender) last = point;
    }
    return last;
  }

  TemporaryDirectory directory_;
};

TEST_F(WorkPrecision, SeesTheOrderThatEachSchemeDeclares) {
  const json curve =
      json_of({"curve", "--time", "1", "--dt-from", "0.0078125", "--levels", "5", "--rounds", "1"});
  for (const SchemePointer& scheme : built_in_schemes()) {
    const SchemeDescription description = scheme->description();
    const json point = last_point(curve, std::string(description.name));
    SCOPED_TRACE(description.name);
    EXPECT_EQ(point["declared_order"], order_text(description.order));
    if (description.order) {
      ASSERT_TRUE(point["observed_order"].is_number()) << point;
      EXPECT_NEAR(point["observed_order"].get<double>(), *description.order, 0.03);  // measured 0.012
    } else {
      EXPECT_LT(point["attitude_error_rad"].get<double>(), 1e-14);  // measured 2e-15
      EXPECT_TRUE(point["observed_order"].is_null()) << "it is rounding";
    }
  }
}

TEST_F(WorkPrecision, SeesThatBulletsOwnAreOfFirstOrderAtMost) {
  const json curve =
      json_of({"curve", "--time", "1", "--dt-from", "0.0078125", "--levels", "3", "--rounds", "1"});
  for (const char* own :
       {"bullet:explicit", "bullet:implicit_world", "bullet:implicit_body", "bullet:multibody"}) {
    EXPECT_EQ(last_point(curve, own)["declared_order"], "1") << own;
    EXPECT_NEAR(last_point(curve, own)["observed_order"].get<double>(), 1.0, 0.05) << own;  // measured 0.016
  }
  EXPECT_GT(last_point(curve, "bullet:none")["attitude_error_rad"], 0.6);  // measured 1.22
}

TEST_F(WorkPrecision, WritesEveryFigureOfACurve) {
  const std::string table =
      work_precision({"curve", "--contender", "rk4", "--contender", "bullet:implicit_body", "--levels", "3",
                      "--rounds", "3", "--csv", file("out.csv"), "--json", file("out.json")})
          .standard_output;
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2 + 2 + 6) << table;
  const json curve = json::parse(read_file(file("out.json")));
  EXPECT_EQ(curve["precision"], POLHODE_BULLET_PRECISION);
  EXPECT_EQ(curve["inertia"], json({1.0, 2.0, 3.0}));
  ASSERT_EQ(curve["points"].size(), 6u);
  for (const json& point : curve["points"]) {
    EXPECT_GT(point["ns_per_step"], 0.0);
    EXPECT_NEAR(point["ns_per_simulated_second"].get<double>() * point["dt_s"].get<double>(),
                point["ns_per_step"].get<double>(), 1e-9 * point["ns_per_step"].get<double>());  // measured 0
    EXPECT_NEAR(point["steps"].get<double>() * point["dt_s"].get<double>(), 10.0,
                1e-6);  // measured 5.3e-7 in single, 0 in double
  }
  const std::string csv = read_file(file("out.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  expect_documented_columns(csv);
}

TEST_F(WorkPrecision, SaysWhereAContenderDivergedOnTheWay) {
  const json curve =
      json_of({"curve", "--contender", "semi_implicit_gyroscopic", "--levels", "1", "--rounds", "1"});
  const json& point = curve["points"][0];
  EXPECT_EQ(point["steps"], 67);
  EXPECT_NEAR(point["diverged_at_s"].get<double>(), 68.0 / 15.0, 1e-12);  // measured 0
  EXPECT_TRUE(point["attitude_error_rad"].is_null());
  EXPECT_TRUE(point["ns_per_step"].is_number());
}

TEST_F(WorkPrecision, TakesAFreeBodyFromAScenario) {
  write_file(file("mine.json"), R"({"inertia": [2, 4, 5], "orientation": [0, 0, 2, 0], "gravity": [0, 0, -9],
                                    "angular_velocity": [1, -2, 3], "dt": 0.01, "duration": 1})");
  const json curve = json_of(
      {"curve", "--scenario", file("mine.json"), "--contender", "rk4", "--levels", "1", "--rounds", "1"});
  EXPECT_EQ(curve["inertia"], json({2.0, 4.0, 5.0}));
  EXPECT_EQ(curve["orientation"], json({0.0, 0.0, 1.0, 0.0}));
  EXPECT_EQ(curve["angular_velocity"], json({1.0, -2.0, 3.0}));
}

TEST_F(WorkPrecision, MeasuresTheCostOfEveryContenderRelativeToBulletsDefault) {
  const json costs = json_of({"cost", "--rounds", "5", "--csv", file("out.csv")});
  ASSERT_EQ(costs["contenders"].size(), built_in_schemes().size() + 5);
  for (const json& cost : costs["contenders"]) {
    for (const char* key : {"free_ns_per_step", "free_ratio_to_implicit_body", "kicked_ns_per_step",
                            "kicked_ratio_to_implicit_body"}) {
      EXPECT_GT(cost[key], 0.0) << cost;
    }
  }
  const json& baseline = costs["contenders"][built_in_schemes().size() + 3];
  EXPECT_EQ(baseline["name"], "bullet:implicit_body");
  // It is compared with itself. The tolerance is wide because other programs may run at the same time;
  // measured 0.997 to 1.001
  EXPECT_NEAR(baseline["free_ratio_to_implicit_body"].get<double>(), 1.0, 0.5);
  expect_documented_columns(read_file(file("out.csv")));
}

}  // namespace
}  // namespace polhode::demos
