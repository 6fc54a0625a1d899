#include "report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "report/base64.h"
#include "report/page_template.h"
#include "scenario/scenario_directory.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Base64, IsAsInItsSpecification) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string_view("\xff\x00\xfe", 3)), "/wD+");
}

TEST(Base64, HoldsNumbersWithTheLeastSignificantByteFirst) {
  EXPECT_EQ(base64(std::vector<float>{1.0F}), base64(std::string_view("\x00\x00\x80\x3f", 4)));
  EXPECT_EQ(base64(std::vector<float>{}), "");
}

Sample varying_sample(std::int64_t step) {
  Sample sample;
  sample.step = step;
  sample.t_s = 0.03 * static_cast<double>(step);
  sample.state.omega_W = {0.1 + 1e-3 * static_cast<double>(step % 997), 10, 0.3};
  sample.state.L_W = {2, 280, 1};
  sample.energy_J = 1400.0 + static_cast<double>(step % 13);
  sample.attitude_error_rad = 1e-3 * static_cast<double>(step % 7);
  return sample;
}

Report report_of(std::size_t contenders, std::int64_t steps) {
  Report report;
  report.comparison.scenario = find_scenario(POLHODE_SCENARIO_SOURCES "/dzhanibekov.json");
  report.comparison.precision = "double";
  report.command = "polhode_compare --scenario 'a </script> b'";
  report.body.boxes = {{Vector3(0.5, 0.1, 0.1), Vector3(0, 0.2, 0), Quaternion::Identity()}};
  for (std::size_t i = 0; i < contenders; ++i) {
    SeriesRecorder recorder(*report.comparison.scenario.body.inertia_B, 0.03, steps,
                            most_records(contenders));
    for (std::int64_t step = 0; step <= steps; ++step) recorder.add(varying_sample(step));
    report.series.push_back(recorder.finish());
    report.comparison.contenders.push_back({"contender_" + std::to_string(i), {}});
    report.summaries.emplace_back("what it does <b>");
  }
  return report;
}

TEST(Report, SaysWhatWasRunAndWhatCameOut) {
  Report report = report_of(2, 10);
  report.comparison.contenders[1].figures.diverged_at_s = 0.25;
  const nlohmann::json json = nlohmann::json::parse(report_json(report));
  EXPECT_EQ(json["scenario"]["name"], "dzhanibekov");
  EXPECT_EQ(json["precision"], "double");
  EXPECT_EQ(json["command"], report.command);
  EXPECT_EQ(json["inertia_B"], (std::vector<double>{24.1449, 28.436, 118.812}));
  EXPECT_EQ(json["body"]["parts"][0]["half_extents"], (std::vector<double>{0.5, 0.1, 0.1}));
  ASSERT_EQ(json["contenders"].size(), 2u);
  EXPECT_EQ(json["contenders"][0]["series"]["count"], 11);
  EXPECT_EQ(json["contenders"][0]["series"]["t_s"], base64(report.series[0].columns.at("t_s")));
  EXPECT_TRUE(json["contenders"][0]["figures"]["diverged_at_s"].is_null());
  EXPECT_EQ(json["contenders"][1]["figures"]["diverged_at_s"], 0.25);
}

// Texts of a scenario or a command must not end the element that holds the data, or start another one.
TEST(Report, LetsNoTextBreakOutOfItsData) {
  Report report = report_of(1, 10);
  report.comparison.scenario.name = "<img src=x onerror=alert(1)>";
  report.comparison.scenario.description = "</script><script>alert(1)//<!--";
  const std::string html = report_html(report);
  const std::size_t start = html.find("id=\"report-data\">");
  ASSERT_NE(start, std::string::npos);
  const std::size_t end = html.find("</script>", start);
  const std::string data = html.substr(html.find('>', start) + 1, end - html.find('>', start) - 1);
  EXPECT_EQ(nlohmann::json::parse(data)["command"], report.command);
  EXPECT_EQ(nlohmann::json::parse(data)["scenario"]["name"], report.comparison.scenario.name);
  EXPECT_EQ(nlohmann::json::parse(data)["scenario"]["description"], report.comparison.scenario.description);
  EXPECT_THAT(data, Not(HasSubstr("<")));
  EXPECT_THAT(html, Not(HasSubstr("@REPORT_DATA@")));
}

TEST(Report, HasTheMomentumOfRotorsWhereThereAreSome) {
  Report report = report_of(2, 10);
  report.comparison.note = "left out: third";
  std::vector<float>& momenta = report.series[1].columns.at("rotor_momentum_W");
  momenta.back() = 1.0F;
  const nlohmann::json json = nlohmann::json::parse(report_json(report));
  EXPECT_EQ(json["contenders"][1]["series"]["rotor_momentum_W"], base64(momenta));
  EXPECT_EQ(json["note"], "left out: third");
  EXPECT_FALSE(json["contenders"][0]["series"].contains("rotor_momentum_W"));
  const nlohmann::json without = nlohmann::json::parse(report_json(report_of(2, 10)));
  EXPECT_FALSE(without.contains("note"));
}

TEST(Report, BringsThePageAllThatIsPlottedAndTabulated) {
  const nlohmann::json json = nlohmann::json::parse(report_json(report_of(1, 10)));
  const auto is_plotted = [&](const Quantity& quantity) {
    return std::any_of(json["plots"].begin(), json["plots"].end(), [&](const nlohmann::json& plot) {
      return plot["key"] == quantity.key && plot["label"] == quantity.label && plot["unit"] == quantity.unit;
    });
  };
  for (const Quantity& quantity : quantities()) {
    EXPECT_EQ(is_plotted(quantity), quantity.is_plotted()) << quantity.key;
    EXPECT_EQ(json["components"].contains(quantity.key), quantity.is_in_report()) << quantity.key;
  }
  EXPECT_EQ(json["columns"].size(), 10u);
  EXPECT_EQ(json["columns"][5]["heading"], "attitude\nmax, rad");
  EXPECT_EQ(json["contenders"][0]["cells"],
            (std::vector<std::string>{"-", "-", "-", "-", "-", "-", "1", "0", "-", "0"}));
}

TEST(Report, StaysUnderTwoMegabytes) {
  for (const std::size_t contenders : {1u, 6u, 9u, 14u}) {
    Report report = report_of(contenders, 20000);
    for (Series& series : report.series) {
      for (auto& column : series.columns) column.second.back() = 1.0F;  // keeps every column
    }
    EXPECT_LT(report_html(report).size(), 2000000u) << contenders;  // measured 1.86e6
  }
}

TEST(PageTemplate, HasOnePlaceForTheData) {
  const std::string_view page = page_template();
  const std::size_t marker = page.find("@REPORT_DATA@");
  ASSERT_NE(marker, std::string_view::npos);
  EXPECT_EQ(page.find("@REPORT_DATA@", marker + 1), std::string_view::npos);
}

}  // namespace
}  // namespace polhode::demos
