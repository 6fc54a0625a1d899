// A comparison as table, CSV and JSON.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "demos/foreign_locale.h"
#include "record/comparison_json.h"
#include "record/csv.h"
#include "record/table.h"

namespace polhode::demos {
namespace {

Comparison small_comparison() {
  Comparison comparison;
  comparison.scenario.name = "thing";
  comparison.scenario.description = "turns";
  comparison.scenario.dt = 0.5;
  comparison.scenario.duration = 5000.0;
  comparison.precision = "double";
  Figures figures;
  figures.steps = 1234567;
  figures.final_energy_error = -0.5;
  figures.worst_energy_error = 1234.5678;
  figures.final_attitude_error_rad = 0.0012345;
  figures.worst_attitude_error_rad = 1.5;
  figures.final_det_R = 1.25;
  figures.steps_past_cut = 1234;
  figures.diverged_at_s = 1.5;
  figures.ns_per_step = 1234.9;
  comparison.contenders = {{"first", figures}, {"second_longer", Figures{}}};
  return comparison;
}

TEST(Table, SaysWhichContendersWereLeftOut) {
  Comparison comparison = small_comparison();
  comparison.note = "left out: third";
  EXPECT_THAT(comparison_table(comparison), testing::ContainsRegex("\nleft out: third\n\ncontender "));
}

Sample small_sample() {
  Sample sample;
  sample.step = 12345;
  sample.t_s = 0.1;
  sample.state.q_WB = Quaternion(1, 2, 3, 4);
  sample.state.omega_W = {5.5, 6, 7};
  sample.state.L_W = {8, 9, 10000.5};
  sample.energy_J = -11;
  sample.attitude_error_rad = 0.25;
  return sample;
}

std::string row_of(const Sample& sample) {
  return csv_row("a:b", {sample, sample, Vector3(1, 1, 1)});
}

constexpr char kRow[] = "a:b,12345,0.10000000000000001,1,2,3,4,5.5,6,7,8,9,10000.5,-11,1,0.25\n";

TEST(Table, IsAlignedWithADashWhereAFigureIsAbsent) {
  std::string text = comparison_table(small_comparison());
  text.erase(text.find(", polhode "), text.find("\n\n") - text.find(", polhode "));
  EXPECT_EQ(text,
            R"(thing: turns
dt 0.5 s, 10000 steps, double-precision Bullet

contender       final     worst      worst  turn of  attitude  attitude  final   fast  diverged  ns per
               E/E0-1  |E/E0-1|  |L| error   L, rad  end, rad  max, rad  det R  steps   at t, s    step
first            -0.5  1.23e+03          -        -   0.00123       1.5   1.25   1234       1.5    1234
second_longer       -         -          -        -         -         -      1      0         -       0
)");
}

TEST(Table, IsTheSameInAnyLocale) {
  const std::string here = comparison_table(small_comparison());
  const ForeignLocale foreign;
  EXPECT_EQ(comparison_table(small_comparison()), here);
}

TEST(Csv, HasTheDocumentedColumns) {
  EXPECT_EQ(csv_header(),
            "contender,step,t_s,q_w,q_x,q_y,q_z,omega_x_rad_s,omega_y_rad_s,omega_z_rad_s,"
            "L_x,L_y,L_z,energy_J,det_R,attitude_error_rad\n");
  EXPECT_EQ(row_of(small_sample()), kRow);
}

TEST(Csv, LeavesTheAttitudeErrorEmptyWhereTheExactMotionIsNotKnown) {
  Sample sample = small_sample();
  sample.attitude_error_rad.reset();
  EXPECT_THAT(row_of(sample), testing::EndsWith(",-11,1,\n"));
}

TEST(Csv, IsTheSameInAnyLocale) {
  const ForeignLocale foreign;
  EXPECT_EQ(row_of(small_sample()), kRow);
}

TEST(ComparisonJson, HasNullWhereAFigureIsAbsent) {
  const ForeignLocale foreign;
  const nlohmann::json json = nlohmann::json::parse(comparison_json(small_comparison()));
  EXPECT_EQ(json["precision"], "double");
  EXPECT_EQ(json["scenario"]["name"], "thing");
  ASSERT_EQ(json["contenders"].size(), 2u);
  const nlohmann::json& first = json["contenders"][0];
  EXPECT_EQ(first["name"], "first");
  EXPECT_EQ(first["steps"], 1234567);
  EXPECT_EQ(first["final_energy_error"], -0.5);
  EXPECT_EQ(first["worst_energy_error"], 1234.5678);
  EXPECT_EQ(first["worst_momentum_error"], nullptr);
  EXPECT_EQ(first["worst_momentum_angle_rad"], nullptr);
  EXPECT_EQ(first["final_attitude_error_rad"], 0.0012345);
  EXPECT_EQ(first["worst_attitude_error_rad"], 1.5);
  EXPECT_EQ(first["final_det_R"], 1.25);
  EXPECT_EQ(first["steps_past_cut"], 1234);
  EXPECT_EQ(first["diverged_at_s"], 1.5);
  EXPECT_EQ(first["ns_per_step"], 1234.9);
  EXPECT_EQ(json["contenders"][1]["diverged_at_s"], nullptr);
  EXPECT_EQ(json["contenders"][1]["final_attitude_error_rad"], nullptr);
  EXPECT_EQ(json["contenders"][1]["worst_attitude_error_rad"], nullptr);
}

}  // namespace
}  // namespace polhode::demos
