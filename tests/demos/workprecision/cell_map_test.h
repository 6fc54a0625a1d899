#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <sstream>
#include <thread>

#include "demos/workprecision/tool.h"

namespace polhode::demos {

/// Runs a subcommand that maps cells as a process: to the end, refused, or interrupted.
class CellMapTest : public testing::Test {
 protected:
  using Texts = std::vector<std::string>;

  /// `command` makes a small map; `long_run` makes it take about a second with one thread.
  CellMapTest(Texts command, Texts long_run) : command_(std::move(command)), long_run_(std::move(long_run)) {}

  Texts arguments(const std::string& file, const Texts& more = {}) const {
    Texts all = command_;
    all.insert(all.end(), {"--csv", (directory_ / file).string()});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  std::string map(const std::string& file, const Texts& more = {}) const {
    work_precision(arguments(file, more));
    return read_file(directory_ / file);
  }

  static std::string line(const std::string& text, int number) {
    std::istringstream stream(text);
    std::string line;
    for (int i = 0; i <= number; ++i) std::getline(stream, line);
    return line;
  }

  std::string expect_refusal(const Texts& more = {}) const {
    const CommandResult result = Command(POLHODE_WORKPRECISION_EXECUTABLE, arguments("out.csv", more)).wait();
    expect_refused_in_one_line(result);
    EXPECT_FALSE(std::filesystem::exists(directory_ / "out.csv"));
    return result.standard_error;
  }

  /// Starts the long run on one thread and returns when some of its cells are in the journal.
  std::unique_ptr<Command> under_way(const std::string& file) const {
    Texts more = long_run_;
    more.insert(more.end(), {"--threads", "1"});
    auto command = std::make_unique<Command>(POLHODE_WORKPRECISION_EXECUTABLE, arguments(file, more));
    for (int i = 0; i < 20000 && lines_of_journal(file) < 5; ++i) {  // sanitizers take seconds for a cell
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return command;
  }

  std::int64_t lines_of_journal(const std::string& file) const {
    const std::string text = read_file(directory_ / (file + ".partial"));
    return std::count(text.begin(), text.end(), '\n');
  }

  void expect_the_same_bytes_for_any_number_of_threads(std::int64_t cells) const {
    const std::string one = map("one.csv", {"--threads", "1", "--json", (directory_ / "one.json").string()});
    EXPECT_EQ(map("seven.csv", {"--threads", "7", "--json", (directory_ / "seven.json").string()}), one);
    EXPECT_EQ(read_file(directory_ / "one.json"), read_file(directory_ / "seven.json"));
    EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 1 + cells);
    EXPECT_EQ(directory_.file_count(), 4) << "and no journal";
    expect_documented_columns(one);
  }

  void expect_to_go_on_where_it_was_killed(std::int64_t cells) const {
    const std::string whole = map("whole.csv", long_run_);
    const auto killed = under_way("out.csv");
    killed->send_signal(SIGKILL);
    EXPECT_EQ(killed->wait().exit_code, -SIGKILL);
    const std::int64_t lines = lines_of_journal("out.csv");
    EXPECT_GE(lines, 5);
    EXPECT_LT(lines, 1 + cells) << "killed too late to show anything";
    EXPECT_FALSE(std::filesystem::exists(directory_ / "out.csv"));
    Texts more = long_run_;
    more.insert(more.end(), {"--threads", "2"});
    EXPECT_EQ(map("out.csv", more), whole);
    EXPECT_EQ(directory_.file_count(), 2) << "the journal is gone";
  }

  TemporaryDirectory directory_;
  Texts command_;
  Texts long_run_;
};

}  // namespace polhode::demos
