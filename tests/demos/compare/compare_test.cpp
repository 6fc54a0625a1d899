// Runs polhode_compare as a process, from end to end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "demos/compare/command.h"
#include "scenario/number_text.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;
using testing::Not;

CommandResult compare(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& environment = {}) {
  CommandResult result = Command(POLHODE_COMPARE_EXECUTABLE, arguments, environment).wait();
  EXPECT_EQ(result.exit_code, 0) << result.standard_error;
  EXPECT_EQ(result.standard_error, "") << "no progress bar where there is no terminal";
  return result;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::map<std::string, nlohmann::json> figures_by_contender(const nlohmann::json& json) {
  std::map<std::string, nlohmann::json> figures;
  for (const nlohmann::json& contender : json["contenders"]) figures[contender["name"]] = contender;
  return figures;
}

TEST(Compare, TellsTheHandoutsStoryByDefault) {
  const TemporaryDirectory directory;
  const CommandResult result = compare({"--json", (directory / "out.json").string()});
  const nlohmann::json json = nlohmann::json::parse(read_file(directory / "out.json"));
  EXPECT_EQ(json["scenario"]["name"], "dzhanibekov");
  EXPECT_EQ(json["precision"], POLHODE_COMPARE_PRECISION);
  EXPECT_THAT(result.standard_output,
              HasSubstr(std::string(POLHODE_COMPARE_PRECISION) + "-precision Bullet"));
  EXPECT_THAT(result.standard_output, HasSubstr("dt 0.03 s, 1000 steps"));

  auto figures = figures_by_contender(json);
  EXPECT_EQ(figures.size(), 9u);
  EXPECT_LT(figures["exact"]["worst_attitude_error_rad"], 1e-9) << "exact has no error";  // measured 2.6e-11
  EXPECT_LT(figures["exact"]["worst_energy_error"], 1e-14);                               // measured 1.3e-15
  EXPECT_GT(figures["bullet:implicit_body"]["worst_attitude_error_rad"], 1.0) << "Bullet loses the motion";
  EXPECT_GT(figures["matrix"]["final_det_R"], 1.1) << "the matrix swells";  // measured 9.3e4
  EXPECT_NEAR(figures["quaternion"]["final_det_R"].get<double>(), 1.0, 1e-14)
      << "the quaternion does not";                                                      // measured 0
  EXPECT_NEAR(figures["quaternion"]["worst_momentum_error"].get<double>(), 0.0, 1e-14);  // measured 0
  EXPECT_GT(figures["semi_implicit_gyroscopic"]["worst_energy_error"], 1e6)
      << "semi-implicit gains energy";  // measured 9e9, 5e12
  EXPECT_GT(figures["semi_implicit_gyroscopic"]["final_energy_error"], 0.0);
  EXPECT_LT(figures["semi_implicit_gyroscopic"]["diverged_at_s"], 30.0)
      << "and blows up";  // measured 26.97, 26.43
  EXPECT_NEAR(figures["implicit_gyroscopic"]["final_energy_error"].get<double>(), 0.25624021 - 1.0, 1e-6)
      << "implicit loses energy";  // measured 6.6e-8 in single, 2.4e-9 in double
  for (const char* mode :
       {"bullet:none", "bullet:explicit", "bullet:implicit_world", "bullet:implicit_body"}) {
    EXPECT_EQ(figures[mode]["steps"], 1000) << mode;
    EXPECT_THAT(result.standard_output, HasSubstr(std::string("\n") + mode + " "));
  }
}

// docs/compare.md shows these figures.
TEST(Compare, ShowsThatAMultibodyGainsEnergyInATumble) {
  const TemporaryDirectory directory;
  compare({"--scenario", "tumble", "--contender", "exact", "--contender", "bullet:implicit_body",
           "--contender", "bullet:multibody", "--json", (directory / "out.json").string(), "--report",
           (directory / "out.html").string()});
  auto figures = figures_by_contender(nlohmann::json::parse(read_file(directory / "out.json")));
  EXPECT_LT(figures["exact"]["worst_energy_error"], 1e-14);             // measured 4.4e-16
  EXPECT_LT(figures["bullet:implicit_body"]["final_energy_error"], 0);  // measured -0.30
  EXPECT_GT(figures["bullet:multibody"]["final_energy_error"], 100.0);  // measured 359
  EXPECT_TRUE(figures["bullet:multibody"]["diverged_at_s"].is_null()) << "Bullet limits its velocity";
  EXPECT_THAT(read_file(directory / "out.html"), HasSubstr("\"bullet:multibody\""));
}

// docs/compare.md shows these figures.
TEST(Compare, ShowsThatFrictionTurnsAPencilOver) {
  const TemporaryDirectory directory;
  compare({"--scenario", "explorer_1", "--contender", "exact", "--contender", "bullet:implicit_body",
           "--contender", "bullet:explicit", "--json", (directory / "out.json").string()});
  auto figures = figures_by_contender(nlohmann::json::parse(read_file(directory / "out.json")));
  EXPECT_NEAR(figures["exact"]["final_energy_error"].get<double>(), -0.796, 0.002);  // measured -0.7959
  EXPECT_LT(figures["exact"]["worst_momentum_error"], 1e-12);                        // measured 0
  EXPECT_NEAR(figures["bullet:implicit_body"]["final_energy_error"].get<double>(), 0,
              0.01);                                                 // measured -1.1e-5
  EXPECT_GT(figures["bullet:explicit"]["final_energy_error"], 1.0);  // measured 1.83
  EXPECT_TRUE(figures["exact"]["worst_attitude_error_rad"].is_null());
}

TEST(Compare, LeavesOutSchemesThatTakeNoRotors) {
  const std::string table = compare({"--scenario", "bicycle_wheel", "--duration", "0.1"}).standard_output;
  EXPECT_THAT(table, HasSubstr("\nleft out, since they take no rotors: matrix\n"));
  EXPECT_THAT(table, Not(HasSubstr("\nmatrix")));
  EXPECT_THAT(compare({"--scenario", "tumble", "--duration", "0.1"}).standard_output,
              Not(HasSubstr("left out")));
}

TEST(Compare, PrintsARowOfAlignedColumnsPerContender) {
  const std::string table = compare({"--scenario", "tumble", "--duration", "1", "--contender", "matrix",
                                     "--contender", "bullet:none"})
                                .standard_output;
  const std::vector<std::string> lines = split(table, '\n');
  ASSERT_EQ(lines.size(), 7u) << table;
  EXPECT_THAT(lines[3], testing::StartsWith("contender "));
  EXPECT_THAT(lines[5], testing::StartsWith("matrix "));
  EXPECT_THAT(lines[6], testing::StartsWith("bullet:none "));
  EXPECT_EQ(lines[5].size(), lines[6].size());
}

TEST(Compare, SaysWhereARunDivergedAndExitsWithSuccess) {
  const TemporaryDirectory directory;
  compare({"--contender", "semi_implicit_gyroscopic", "--json", (directory / "out.json").string(), "--csv",
           (directory / "out.csv").string()});
  const nlohmann::json json = nlohmann::json::parse(read_file(directory / "out.json"));
  const nlohmann::json& figures = json["contenders"][0];
  ASSERT_TRUE(figures["diverged_at_s"].is_number());
  const std::vector<std::string> lines = split(read_file(directory / "out.csv"), '\n');
  const auto steps = figures["steps"].get<std::size_t>();
  EXPECT_EQ(lines.size(), steps + 2) << "header, start and each finite step";
  EXPECT_NEAR(figures["diverged_at_s"].get<double>(), 0.03 * static_cast<double>(steps + 1),
              1e-12);  // measured 0
}

TEST(Compare, WritesEveryStepWithAllDigits) {
  const TemporaryDirectory directory;
  compare(
      {"--scenario", "tumble", "--dt", "0.01", "--duration", "1", "--csv", (directory / "out.csv").string()});
  const std::vector<std::string> lines = split(read_file(directory / "out.csv"), '\n');
  ASSERT_EQ(lines.size(), 1u + 9u * 101u);
  EXPECT_EQ(lines[0],
            "contender,step,t_s,q_w,q_x,q_y,q_z,omega_x_rad_s,omega_y_rad_s,omega_z_rad_s,"
            "L_x,L_y,L_z,energy_J,det_R,attitude_error_rad");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i], ',');
    ASSERT_EQ(cells.size(), 16u);
    EXPECT_EQ(cells[1], number_text(static_cast<std::int64_t>((i - 1) % 101)));
    for (std::size_t column = 2; column < cells.size(); ++column) {
      const std::optional<double> value = parse_number(cells[column]);
      ASSERT_TRUE(value) << cells[column];
      EXPECT_EQ(full_number_text(*value), cells[column]);
    }
  }
}

// Returns the data of the report's page, without the page.
nlohmann::json report_data(const std::string& html) {
  const std::string opening = "id=\"report-data\">";
  const std::size_t start = html.find(opening) + opening.size();
  return nlohmann::json::parse(html.substr(start, html.find("</script>", start) - start));
}

TEST(Compare, WritesAReportThatNeedsNothingElse) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "a report.html").string();
  compare({"--contender", "exact", "--contender", "semi_implicit_gyroscopic", "--report", file, "--json",
           (directory / "out.json").string()});
  const std::string html = read_file(file);
  EXPECT_LT(html.size(), 2000000u);  // measured 8.9e5
  const nlohmann::json data = report_data(html);
  EXPECT_THAT(data["command"].get<std::string>(), testing::StartsWith("polhode_compare"));
  EXPECT_THAT(data["command"].get<std::string>(), HasSubstr("--report '" + file + "'"));
  const nlohmann::json figures = nlohmann::json::parse(read_file(directory / "out.json"));
  for (std::size_t i = 0; i < 2; ++i) {
    nlohmann::json expected = figures["contenders"][i];
    EXPECT_EQ(data["contenders"][i]["name"], expected["name"]);
    expected.erase("name");
    EXPECT_EQ(data["contenders"][i]["figures"], expected);
  }
  EXPECT_EQ(data["contenders"][0]["series"]["count"], 1001);
  EXPECT_FALSE(data["contenders"][1]["figures"]["diverged_at_s"].is_null());
  EXPECT_LT(data["contenders"][1]["series"]["count"], 1001);
}

TEST(Compare, StartsTheRecordWhereTheScenarioStarts) {
  const TemporaryDirectory directory;
  compare({"--scenario", "tumble", "--duration", "1", "--csv", (directory / "out.csv").string()});
  int starts = 0;
  for (const std::string& line : split(read_file(directory / "out.csv"), '\n')) {
    const std::vector<std::string> cells = split(line, ',');
    if (cells[1] != "0") continue;
    ++starts;
    const std::vector<std::string> values(cells.begin() + 2, cells.end());
    // L = I omega and E = 1/2 omega . L: whole numbers, the same in both precisions up to what Bullet's 1/I
    // loses
    const double expected[] = {0, 1, 0, 0, 0, 3, 2, 4, 3, 4, 12, 32.5, 1, 0};
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(parse_number(values[i]).value(), expected[i], 2e-6)
          << cells[0] << " column " << i + 2;  // measured 7.2e-7 in single, 0 in double
    }
  }
  EXPECT_EQ(starts, 9);
}

TEST(Compare, WritesTheSameDigitsInAnyLocale) {
  const TemporaryDirectory directory;
  const auto record = [&](const std::string& locale) {
    const std::string file = (directory / "out.csv").string();
    compare({"--scenario", "tumble", "--duration", "1", "--csv", file},
            {"LC_ALL=" + locale, "LANG=" + locale});
    return read_file(file);
  };
  EXPECT_EQ(record("de_DE.UTF-8"), record("C"));
}

TEST(Compare, RunsAFileThatHoldsAFreeBodyAlone) {
  const TemporaryDirectory directory;
  write_file(directory / "mine.json", R"({"inertia": [1, 2, 3], "orientation": [1, 0, 0, 0],
                                           "angular_velocity": [1, 2, 3], "dt": 0.01, "duration": 1})");
  EXPECT_THAT(compare({"--scenario", (directory / "mine.json").string()}).standard_output,
              testing::StartsWith("mine\ndt 0.01 s, 100 steps"));
}

TEST(Compare, ReadsBackTheScenarioItResolved) {
  const TemporaryDirectory directory;
  const auto scenario_of = [&](const std::string& scenario) {
    const std::string file = (directory / "out.json").string();
    compare({"--scenario", scenario, "--dt", "0.02", "--duration", "0.2", "--contender", "bullet:none",
             "--json", file});
    return nlohmann::json::parse(read_file(file))["scenario"];
  };
  const nlohmann::json first = scenario_of("floor");
  EXPECT_EQ(first["dt"], 0.02);
  EXPECT_EQ(first["others"].size(), 2u);
  EXPECT_EQ(first["inertia"].size(), 3u) << "the one of the shape, spelled out";
  write_file(directory / "again.json", first.dump());
  EXPECT_EQ(scenario_of((directory / "again.json").string()), first);
}

TEST(Compare, ListsScenariosAndContendersALineEach) {
  const std::vector<std::string> lines = split(compare({"--list"}).standard_output, '\n');
  std::vector<std::string> first_words;
  first_words.reserve(lines.size());
  for (const std::string& line : lines) first_words.push_back(line.substr(0, line.find(' ')));
  EXPECT_THAT(first_words,
              testing::IsSupersetOf({"scenarios:", "cube_expansion", "dzhanibekov", "fast_spinner", "floor",
                                     "heavy_top", "t_handle", "tumble", "contenders:", "matrix", "quaternion",
                                     "semi_implicit_gyroscopic", "implicit_gyroscopic", "bullet",
                                     "bullet:none", "bullet:explicit", "bullet:implicit_world",
                                     "bullet:implicit_body", "bullet:multibody"}));
}

TEST(Compare, ExplainsItself) {
  EXPECT_THAT(compare({"--help"}).standard_output,
              testing::AllOf(HasSubstr("--scenario"), HasSubstr("NAME|FILE.json"), HasSubstr("dzhanibekov")));
  EXPECT_THAT(compare({"--version"}).standard_output,
              testing::MatchesRegex("polhode [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Compare, LeavesNoFileWhenItIsStopped) {
  const TemporaryDirectory directory;
  Command command(POLHODE_COMPARE_EXECUTABLE,
                  {"--scenario", "tumble", "--dt", "0.001", "--duration", "50000", "--contender",
                   "bullet:none", "--csv", (directory / "out.csv").string()});
  for (int tenth = 0; tenth < 100 && directory.file_count() == 0; ++tenth) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_EQ(directory.file_count(), 1) << "the temporary file";
  command.send_signal(SIGTERM);
  const CommandResult result = command.wait();
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  EXPECT_THAT(result.standard_error, HasSubstr("interrupted; no file was written"));
  EXPECT_EQ(directory.file_count(), 0);
}

}  // namespace
}  // namespace polhode::demos
