// Runs polhode_workprecision map as a process: the bytes do not depend on who computes them, or on kills and
// resumes.
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "demos/workprecision/cell_map_test.h"
#include "workprecision/map_grid.h"

namespace polhode::demos {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class StabilityMap : public CellMapTest {
 protected:
  StabilityMap()
      : CellMapTest({"map", "--scheme", "rk4", "--scheme", "semi_implicit_gyroscopic", "--omega-dt", "0.05",
                     "2", "8", "--inertia-ratio", "1.2", "5", "5"},
                    {"--steps", "100000"}) {}

  static std::string first_line_of_journal(std::int64_t steps = 1000) {
    MapGrid grid;
    grid.steps = steps;
    grid.contenders = find_contenders({"rk4", "semi_implicit_gyroscopic"});
    grid.omega_dt = {0.05, 2.0, 8};
    grid.inertia_ratio = {1.2, 5.0, 5};
    return grid.description() + "\n";
  }
};

TEST_F(StabilityMap, HasTheSameBytesForAnyNumberOfThreads) {
  expect_the_same_bytes_for_any_number_of_threads(2 * 8 * 5);
}

TEST_F(StabilityMap, MarksWhatDiverged) {
  const std::string csv = map("out.csv", {"--json", (directory_ / "out.json").string()});
  const json contenders = json::parse(read_file(directory_ / "out.json"))["contenders"];
  ASSERT_EQ(contenders.size(), 2u);
  const auto diverged_cells = [](const json& contender) {
    const json& steps = contender["diverged_at_step"];
    return std::count_if(steps.begin(), steps.end(), [](const json& step) { return step.is_number(); });
  };
  EXPECT_EQ(contenders[0]["worst_energy_error"].size(), 40u);
  EXPECT_EQ(diverged_cells(contenders[0]), 0);
  EXPECT_EQ(diverged_cells(contenders[1]), 21);
  EXPECT_THAT(csv, HasSubstr(",diverged,"));
  EXPECT_THAT(csv, testing::Not(HasSubstr("nan")));
  EXPECT_THAT(csv, testing::Not(HasSubstr("inf")));
}

TEST_F(StabilityMap, GoesOnWhereItWasKilled) {
  expect_to_go_on_where_it_was_killed(2 * 8 * 5);
}

TEST_F(StabilityMap, SaysWhereItStandsWhenItIsStopped) {
  const auto stopped = under_way("out.csv");
  stopped->send_signal(SIGTERM);
  const CommandResult result = stopped->wait();
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  EXPECT_THAT(result.standard_error, HasSubstr("out.csv.partial\", from which the same command resumes"));
  EXPECT_EQ(directory_.file_count(), 1) << "the journal";
}

TEST_F(StabilityMap, BelievesItsJournalAndIgnoresATornLine) {
  const std::string clean = map("clean.csv");
  // A value that no computation gives, then lines as a kill may leave them.
  for (const char* torn : {"", "1", "1 0.2", "1 0.25 0", "1 x 0\n", "99 1 0\n", "1 0.25 0 7\n", "\n"}) {
    write_file(directory_ / "out.csv.partial", first_line_of_journal() + "3 0.125 17\n" + torn);
    const std::string resumed = map("out.csv");
    EXPECT_THAT(line(resumed, 4), testing::EndsWith(",diverged,0.125,17")) << torn;
    for (const int other : {1, 2, 3, 5, 80}) EXPECT_EQ(line(resumed, other), line(clean, other)) << torn;
  }
}

TEST_F(StabilityMap, AppendsNothingToATornLine) {
  const std::string whole = map("whole.csv", long_run_);
  // Before the line of cell 0 this digit would make it cell 10's.
  write_file(directory_ / "out.csv.partial", first_line_of_journal(100000) + "1");
  const auto killed = under_way("out.csv");
  killed->send_signal(SIGKILL);
  killed->wait();
  EXPECT_EQ(map("out.csv", long_run_), whole);
}

TEST_F(StabilityMap, StartsOverWhereNotEvenTheFirstLineIsWhole) {
  const std::string first_line = first_line_of_journal();
  const std::string clean = map("clean.csv");
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, first_line.size() - 1}) {
    write_file(directory_ / "out.csv.partial", first_line.substr(0, length));
    EXPECT_EQ(map("out.csv"), clean) << length;
  }
}

TEST_F(StabilityMap, RefusesTheJournalOfAnotherMapAndSaysWhatDiffers) {
  write_file(directory_ / "out.csv.partial", first_line_of_journal() + "3 0.125 17\n");
  const std::string message = expect_refusal({"--steps", "77", "--start", "generic"});
  EXPECT_THAT(message, HasSubstr("steps is 1000 there and 77 here"));
  EXPECT_THAT(message, HasSubstr("start is \"middle_axis\" there and \"generic\" here"));
  EXPECT_THAT(message, HasSubstr("delete it, or start over with --restart"));
  EXPECT_THAT(message, testing::Not(HasSubstr("omega_dt")));
  EXPECT_EQ(read_file(directory_ / "out.csv.partial"), first_line_of_journal() + "3 0.125 17\n");
  map("out.csv", {"--steps", "77", "--start", "generic", "--restart"});
}

TEST_F(StabilityMap, RefusesAFileThatIsNoJournal) {
  write_file(directory_ / "out.csv.partial", "dear diary\n");
  EXPECT_THAT(expect_refusal(), HasSubstr("it is not the journal of a map"));
  EXPECT_EQ(read_file(directory_ / "out.csv.partial"), "dear diary\n");
}

// 2 * 200 * 200 cells, as a program that ran for hours may leave them.
TEST_F(StabilityMap, GoesOnFromAJournalOfMegabytes) {
  const Texts large = {"--omega-dt", "0.05", "2", "200", "--inertia-ratio", "1.2", "5", "200"};
  command_.resize(5);
  MapGrid grid;
  grid.contenders = find_contenders({"rk4", "semi_implicit_gyroscopic"});
  grid.omega_dt = {0.05, 2.0, 200};
  grid.inertia_ratio = {1.2, 5.0, 200};
  std::string journal = grid.description() + "\n";
  for (int cell = 0; cell < 80000; ++cell) journal += std::to_string(cell) + " 0.125 0\n";
  write_file(directory_ / "out.csv.partial", journal);
  const std::string csv = map("out.csv", large);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 80001);
  EXPECT_THAT(line(csv, 80000), testing::EndsWith(",finite,0.125,"));

  write_file(directory_ / "out.csv.partial", journal + "0 0.5 0\n");
  std::filesystem::remove(directory_ / "out.csv");
  EXPECT_THAT(expect_refusal(large), HasSubstr("holds more cells than this map has, 80000; delete it"));
  EXPECT_EQ(read_file(directory_ / "out.csv.partial"), journal + "0 0.5 0\n");
}

TEST_F(StabilityMap, ReadsAHostileJournalInLittleMemory) {
  const std::filesystem::path journal = directory_ / "out.csv.partial";
  for (const std::string& begin : {std::string(1000000, '['), "{\"steps\": " + std::string(50000, '[') + "\n",
                                   std::string("\x1b[2J\xff\n"), std::string("{}"), std::string()}) {
    write_file(journal, begin);
    std::filesystem::resize_file(journal, std::uintmax_t{2} << 30);  // with zeros
    const CommandResult result = Command(POLHODE_WORKPRECISION_EXECUTABLE, arguments("out.csv")).wait();
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.standard_error, HasSubstr("it is not the journal of a map"));
    EXPECT_LT(result.peak_megabytes, 60.0 * kMemoryFactor);  // measured 15
    EXPECT_LT(result.processor_seconds, 1.0);                // measured 0.005
  }
  write_file(journal, "{\"steps\": \"\\u001b[2J\u202e" + std::string(50000, 'a') + "\"}\n");
  const std::string message = expect_refusal();
  EXPECT_THAT(message, HasSubstr("steps is \"\\u001b[2J\\xe2\\x80\\xaeaaa"));
  EXPECT_LT(message.size(), 3000u);  // measured 1530
}

TEST_F(StabilityMap, TakesNoOtherCellsFromAHostileJournal) {
  const std::string clean = map("clean.csv");
  for (const char* cell : {"3 nan 17\n", "3 inf 17\n", "3 -inf 17\n", "80 0 0\n", "-1 0 0\n"}) {
    write_file(directory_ / "out.csv.partial", first_line_of_journal() + cell);
    std::filesystem::resize_file(directory_ / "out.csv.partial", std::uintmax_t{2} << 30);
    EXPECT_EQ(map("out.csv"), clean) << cell;
  }
}

TEST_F(StabilityMap, RefusesAJournalThatIsNoRegularFile) {
  std::filesystem::create_symlink("/dev/zero", directory_ / "out.csv.partial");
  EXPECT_THAT(expect_refusal(),
              HasSubstr("out.csv.partial\": the journal is not a regular file; choose another output file"));
  std::filesystem::remove(directory_ / "out.csv.partial");
  ASSERT_EQ(::mkfifo((directory_ / "out.csv.partial").c_str(), 0600), 0);
  EXPECT_THAT(expect_refusal({"--restart"}), HasSubstr("the journal is not a regular file"));
}

TEST_F(StabilityMap, RefusesAJournalThatAnotherRunIsWriting) {
  const auto first = under_way("out.csv");
  EXPECT_THAT(expect_refusal(long_run_), HasSubstr("another run is using it"));
  first->send_signal(SIGKILL);
  first->wait();
}

}  // namespace
}  // namespace polhode::demos
