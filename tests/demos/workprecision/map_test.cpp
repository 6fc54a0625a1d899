// polhode_workprecision map, as a process: the same bytes whoever computes them, and however often it is
// killed.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "demos/workprecision/tool.h"
#include "workprecision/map_grid.h"

namespace polhode::demos {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class StabilityMap : public testing::Test {
 protected:
  std::vector<std::string> arguments(const std::string& file,
                                     const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = {
        "map",        "--scheme", "rk4", "--scheme", "semi_implicit_gyroscopic",
        "--omega-dt", "0.05",     "2",   "8",        "--inertia-ratio",
        "1.2",        "5",        "5",   "--csv",    (directory_ / file).string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  std::string map(const std::string& file, const std::vector<std::string>& more = {}) const {
    work_precision(arguments(file, more));
    return read_file(directory_ / file);
  }

  static std::string first_line_of_journal(std::int64_t steps = 1000) {
    MapGrid grid;
    grid.steps = steps;
    grid.contenders = find_contenders({"rk4", "semi_implicit_gyroscopic"});
    grid.omega_dt = {0.05, 2.0, 8};
    grid.inertia_ratio = {1.2, 5.0, 5};
    return description(grid) + "\n";
  }

  static std::string line(const std::string& text, int number) {
    std::istringstream stream(text);
    std::string line;
    for (int i = 0; i <= number; ++i) std::getline(stream, line);
    return line;
  }

  std::string expect_refusal(const std::vector<std::string>& more = {}) const {
    const CommandResult result = Command(POLHODE_WORKPRECISION_EXECUTABLE, arguments("out.csv", more)).wait();
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(std::count(result.standard_error.begin(), result.standard_error.end(), '\n'), 1);
    EXPECT_FALSE(std::filesystem::exists(directory_ / "out.csv"));
    return result.standard_error;
  }

  // A map that takes about a second, under way: some of its cells are in the journal.
  std::unique_ptr<Command> under_way(const std::string& file) const {
    auto command = std::make_unique<Command>(POLHODE_WORKPRECISION_EXECUTABLE, arguments(file, long_run_));
    for (int i = 0; i < 1000 && lines_of_journal(file) < 5; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return command;
  }

  std::int64_t lines_of_journal(const std::string& file) const {
    const std::string text = read_file(directory_ / (file + ".partial"));
    return std::count(text.begin(), text.end(), '\n');
  }

  TemporaryDirectory directory_;
  std::vector<std::string> long_run_ = {"--steps", "100000", "--threads", "1"};
};

TEST_F(StabilityMap, HasTheSameBytesForAnyNumberOfThreads) {
  const std::string one = map("one.csv", {"--threads", "1", "--json", (directory_ / "one.json").string()});
  EXPECT_EQ(map("seven.csv", {"--threads", "7", "--json", (directory_ / "seven.json").string()}), one);
  EXPECT_EQ(read_file(directory_ / "one.json"), read_file(directory_ / "seven.json"));
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 1 + 2 * 8 * 5);
  EXPECT_EQ(directory_.file_count(), 4) << "and no journal";
  expect_documented_columns(one);
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
  const std::string whole = map("whole.csv", long_run_);
  const auto killed = under_way("out.csv");
  killed->send_signal(SIGKILL);
  EXPECT_EQ(killed->wait().exit_code, -1);
  const std::int64_t lines = lines_of_journal("out.csv");
  EXPECT_GE(lines, 5);
  EXPECT_LT(lines, 81) << "killed too late to show anything";
  EXPECT_FALSE(std::filesystem::exists(directory_ / "out.csv"));
  EXPECT_EQ(map("out.csv", {"--steps", "100000", "--threads", "2"}), whole);
  EXPECT_EQ(directory_.file_count(), 2) << "the journal is gone";
}

TEST_F(StabilityMap, SaysWhereItStandsWhenItIsStopped) {
  const auto stopped = under_way("out.csv");
  stopped->send_signal(SIGTERM);
  const CommandResult result = stopped->wait();
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  EXPECT_THAT(result.standard_error, HasSubstr("out.csv.partial\", from which the same command goes on"));
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
  // Before the line of cell 0 this would make it cell 10's.
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
  EXPECT_THAT(expect_refusal(), HasSubstr("it is no journal of a map"));
  EXPECT_EQ(read_file(directory_ / "out.csv.partial"), "dear diary\n");
}

TEST_F(StabilityMap, RefusesAJournalThatAnotherRunIsWriting) {
  const auto first = under_way("out.csv");
  EXPECT_THAT(expect_refusal(long_run_), HasSubstr("another run is writing it"));
  first->send_signal(SIGKILL);
  first->wait();
}

}  // namespace
}  // namespace polhode::demos
