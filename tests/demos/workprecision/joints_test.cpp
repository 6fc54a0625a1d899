// Runs polhode_workprecision joints as a process: the bytes do not depend on who computes them, and a count
// in the CSV confirms the verdict.
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "demos/workprecision/cell_map_test.h"
#include "workprecision/joints/joints_grid.h"
#include "workprecision/map_grid.h"

namespace polhode::demos {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr std::int64_t kCells = 6 * 4 * 2 * 2;  // of each contender

class JointsMap : public CellMapTest {
 protected:
  // matrix gains energy wherever something acts, so the counts are not 0.
  JointsMap()
      : CellMapTest({"joints", "--scheme", "exact", "--scheme", "matrix", "--omega-dt", "0.05", "2", "4",
                     "--inertia-ratio", "1.5", "20", "2", "--tilt", "0.1", "0.8", "2", "--time", "2"},
                    {"--dt", "0.004"}) {}

  static std::string first_line_of_journal() {
    JointsGrid grid;
    grid.contenders = schemes_and_bullet({"exact", "matrix"});
    grid.omega_dt = {0.05, 2.0, 4};
    grid.inertia_ratio = {1.5, 20.0, 2};
    grid.tilt = {0.1, 0.8, 2};
    grid.time_s = 2.0;
    return grid.description() + "\n";
  }
};

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// A row of a CSV by the names of its columns.
std::vector<Row> rows_of(const std::string& csv) {
  std::vector<std::string> lines = split(csv, '\n');
  const std::vector<std::string> names = split(lines.front(), ',');
  std::vector<Row> rows;
  for (auto line = lines.begin() + 1; line != lines.end(); ++line) {
    const std::vector<std::string> values = split(*line + ",", ',');
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = i < values.size() ? values[i] : "";
    rows.push_back(row);
  }
  return rows;
}

bool is_worse(const Row& scheme, const Row& bullet, const std::string& column,
              const std::function<double(double)>& limit) {
  if (bullet.at("state") == "diverged") return false;
  if (scheme.at("state") == "diverged") return true;
  return std::stod(scheme.at(column)) > limit(std::stod(bullet.at(column)));
}

struct Counts {
  int joint_error = 0;
  int energy_gain = 0;
  int motor_speed = 0;
  int diverged = 0;
};

Counts counted(const std::vector<Row>& rows, const std::string& scheme_name) {
  std::map<std::string, Row> bullet;
  const auto cell = [](const Row& row) {
    return row.at("kind") + row.at("omega_dt_rad") + row.at("inertia_ratio") + row.at("tilt_rad");
  };
  for (const Row& row : rows) {
    if (row.at("contender") == "bullet:implicit_body") bullet[cell(row)] = row;
  }
  Counts counts;
  for (const Row& row : rows) {
    if (row.at("contender") != scheme_name) continue;
    const Row& other = bullet.at(cell(row));
    counts.diverged += row.at("state") == "diverged" ? 1 : 0;
    counts.joint_error += is_worse(row, other, "joint_error_rad", [](double x) { return x + 1e-3; });
    if (row.at("kind") == "motor") {
      counts.motor_speed += is_worse(row, other, "motor_speed_error", [](double x) { return x + 0.01; });
    } else {
      const auto limit = [](double x) { return std::max(1.02, 1.02 * x); };
      counts.energy_gain += is_worse(row, other, "energy_gain", limit);
    }
  }
  return counts;
}

TEST_F(JointsMap, HasTheSameBytesForAnyNumberOfThreads) {
  expect_the_same_bytes_for_any_number_of_threads(6 * kCells);
}

TEST_F(JointsMap, GoesOnWhereItWasKilled) {
  expect_to_go_on_where_it_was_killed(6 * kCells);
}

TEST_F(JointsMap, BelievesItsJournalAndIgnoresATornLine) {
  const std::string clean = map("clean.csv");
  // Values that no computation gives: for a hinge, for a cell that diverged, and for a motor (from cell 16
  // on).
  const std::string planted = "1 0.5 3.25 0 0\n3 0 0 0 17\n16 0.5 0 0.125 0\n";
  for (const char* torn : {"", "2 0.5 0.25", "2 0.5 0.25 0\n", "2 0.5 0.25 x 0\n", "99999 1 1 1 0\n"}) {
    write_file(directory_ / "out.csv.partial", first_line_of_journal() + planted + torn);
    const std::string resumed = map("out.csv");
    EXPECT_THAT(line(resumed, 2), testing::EndsWith(",finite,0.5,3.25,,")) << torn;
    EXPECT_THAT(line(resumed, 4), testing::EndsWith(",diverged,,,,17")) << torn;
    EXPECT_THAT(line(resumed, 17), testing::EndsWith(",finite,0.5,,0.125,")) << torn;
    for (const int other : {1, 3, 5, 16, 18, 576})
      EXPECT_EQ(line(resumed, other), line(clean, other)) << torn;
  }
}

TEST_F(JointsMap, RefusesTheJournalOfAnotherMapAndSaysWhatDiffers) {
  write_file(directory_ / "out.csv.partial", first_line_of_journal());
  EXPECT_THAT(expect_refusal({"--kind", "weld"}), HasSubstr("kinds is [\"hinge\",\"motor\","));
  EXPECT_THAT(expect_refusal({"--dt", "0.01"}), HasSubstr(" there and 0.01 here"));
  write_file(directory_ / "out.csv.partial", MapGrid().description() + "\n");
  EXPECT_THAT(expect_refusal(), HasSubstr("journal is \"polhode_workprecision map 1\" there"));
}

TEST_F(JointsMap, CountsWhereASchemeIsWorseThanBullet) {
  const std::string json_file = (directory_ / "out.json").string();
  const std::string output = work_precision(arguments("out.csv", {"--json", json_file})).standard_output;
  const std::vector<Row> rows = rows_of(read_file(directory_ / "out.csv"));
  const json verdicts = json::parse(read_file(json_file))["verdicts"];
  ASSERT_EQ(verdicts.size(), 2u);
  for (const json& verdict : verdicts) {
    const std::string scheme = verdict["scheme"];
    const Counts counts = counted(rows, scheme);
    EXPECT_EQ(verdict["cells"], kCells) << scheme;
    EXPECT_EQ(verdict["cells_with_energy"], kCells * 5 / 6) << scheme;
    EXPECT_EQ(verdict["worse_joint_error"], counts.joint_error) << scheme;
    EXPECT_EQ(verdict["worse_energy_gain"], counts.energy_gain) << scheme;
    EXPECT_EQ(verdict["worse_motor_speed_error"], counts.motor_speed) << scheme;
    EXPECT_EQ(verdict["diverged"], counts.diverged) << scheme;
    EXPECT_THAT(output, HasSubstr(scheme + " against bullet:implicit_body: joint error worse in " +
                                  std::to_string(counts.joint_error) + " of 96 cells, energy gain in " +
                                  std::to_string(counts.energy_gain) + " of 80, motor speed in " +
                                  std::to_string(counts.motor_speed) + " of 16;"));
  }
  EXPECT_EQ(verdicts[1]["scheme"], "matrix");
  EXPECT_GT(verdicts[1]["worse_energy_gain"], 0) << "or nothing was counted";
}

TEST_F(JointsMap, WritesTheSameCellsAsCsvAndAsJson) {
  const std::string json_file = (directory_ / "out.json").string();
  const std::vector<Row> rows =
      rows_of(map("out.csv", {"--json", json_file, "--kind", "hinge", "--kind", "motor"}));
  const json map = json::parse(read_file(json_file));
  EXPECT_EQ(map["kinds"], json({"hinge", "motor"}));
  EXPECT_EQ(map["tilt"], json({0.1, 0.8}));
  std::size_t row = 0;
  for (const json& contender : map["contenders"]) {
    for (std::size_t i = 0; i < 32; ++i, ++row) {
      EXPECT_EQ(rows.at(row).at("contender"), contender["name"]);
      EXPECT_EQ(rows.at(row).at("kind"), i < 16 ? "hinge" : "motor");
      EXPECT_EQ(std::stod(rows.at(row).at("tilt_rad")), map["tilt"][i % 2]);
      EXPECT_EQ(std::stod(rows.at(row).at("inertia_ratio")), map["inertia_ratio"][i / 2 % 2]);
      EXPECT_EQ(std::stod(rows.at(row).at("omega_dt_rad")), map["omega_dt"][i / 4 % 4]);
      for (const auto& [column, key] :
           std::map<std::string, std::string>{{"joint_error_rad", "joint_error"},
                                              {"energy_gain", "energy_gain"},
                                              {"motor_speed_error", "motor_speed_error"},
                                              {"diverged_at_step", "diverged_at_step"}}) {
        const std::string text = rows.at(row).at(column);
        EXPECT_EQ(contender[key].at(i), text.empty() ? json(nullptr) : json::parse(text)) << column << row;
      }
    }
  }
  EXPECT_EQ(row, rows.size());
}

}  // namespace
}  // namespace polhode::demos
