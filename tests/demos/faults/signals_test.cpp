// After a signal during writing, the file is complete or as it was before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "demos/faults/writers.h"

namespace polhode::demos {
namespace {

using Clock = std::chrono::steady_clock;

class Signal : public WriterTest {
 protected:
  // Sends signals to runs at times spread over their duration. Calls expect(result) after each.
  template <class Expect>
  void at_any_moment(int signal, const Expect& expect) {
    constexpr int kMoments = 6;
    const Clock::time_point before = Clock::now();
    whole_ = clean_text();
    const Clock::duration duration = Clock::now() - before;
    for (int moment = 0; moment <= kMoments; ++moment) {
      write_file(target(), "before");
      Command command = start();
      std::this_thread::sleep_for(duration * moment / kMoments);
      command.send_signal(signal);
      const CommandResult result = command.wait();
      if (read_file(target()) != "before") expect_whole();
      expect(result, command.process());
      for (const auto& entry : std::filesystem::directory_iterator(directory_.path())) {
        std::filesystem::remove(entry);
      }
    }
  }

  void expect_whole() const {
    const std::string text = read_file(target());
    EXPECT_TRUE(!GetParam().is_reproducible || text == whole_);
    EXPECT_GT(text.size(), whole_.size() * 3 / 4);
    EXPECT_EQ(text.back(), whole_.back());
  }

  std::string whole_;
};

TEST_P(Signal, ToTerminateLeavesNothingElse) {
  at_any_moment(SIGTERM, [&](const CommandResult& result, int /*process*/) {
    // Before the program has installed its handler, the signal kills it.
    EXPECT_THAT(result.exit_code, testing::AnyOf(0, -SIGTERM, 128 + SIGTERM)) << result.standard_error;
    EXPECT_EQ(directory_.file_count(), 1 + kept_files());
    if (result.exit_code == 0) expect_whole();
  });
}

TEST_P(Signal, ToKillLeavesARecognisableRemainderThatDisturbsNoLaterRun) {
  at_any_moment(SIGKILL, [&](const CommandResult& result, int process) {
    EXPECT_THAT(result.exit_code, testing::AnyOf(0, -SIGKILL)) << result.standard_error;
    const std::filesystem::path remainder = target().string() + ".partial-" + std::to_string(process);
    const int remainders = std::filesystem::exists(remainder) ? 1 : 0;
    EXPECT_EQ(directory_.file_count(), 1 + kept_files() + remainders);
    EXPECT_EQ(start().wait().exit_code, 0);
    expect_whole();
    EXPECT_EQ(directory_.file_count(), 1 + remainders);
  });
}

INSTANTIATE_TEST_SUITE_P(Demos, Signal, testing::ValuesIn(writers()), name_of);

#ifdef POLHODE_COMPARE_EXECUTABLE
/// A comparison that has written some of its rows and is far from the last.
class HalfWritten : public testing::Test {
 protected:
  HalfWritten()
      : command_(POLHODE_COMPARE_EXECUTABLE,
                 {"--scenario", "tumble", "--dt", "0.001", "--duration", "900", "--contender", "bullet:none",
                  "--csv", (directory_ / "out").string()}) {
    const std::filesystem::path partial = directory_ / ("out.partial-" + std::to_string(command_.process()));
    std::error_code error;
    for (int i = 0; i < 1000; ++i) {
      const auto size = std::filesystem::file_size(partial, error);
      if (!error && size > 0) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "it wrote nothing";
  }

  CommandResult end_by(int signal) {
    command_.send_signal(signal);
    return command_.wait();
  }

  TemporaryDirectory directory_;
  Command command_;
};

TEST_F(HalfWritten, FileIsGoneAfterAnInterrupt) {
  EXPECT_EQ(end_by(SIGINT).exit_code, 128 + SIGINT);
  EXPECT_EQ(directory_.file_count(), 0);
}

TEST_F(HalfWritten, FileIsGoneAfterTheTerminalIs) {
  EXPECT_EQ(end_by(SIGHUP).exit_code, 128 + SIGHUP);
  EXPECT_EQ(directory_.file_count(), 0);
}

TEST_F(HalfWritten, FileHasAnotherNameAfterAKill) {
  EXPECT_EQ(end_by(SIGKILL).exit_code, -SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(directory_ / "out"));
  EXPECT_EQ(directory_.file_count(), 1);
}

TEST(IgnoredSignal, StaysIgnored) {
  const TemporaryDirectory directory;
  Command command(POLHODE_COMPARE_EXECUTABLE,
                  {"--scenario", "tumble", "--contender", "exact", "--dt", "0.001", "--csv",
                   (directory / "out").string()},
                  {}, [] { std::signal(SIGHUP, SIG_IGN); });  // as nohup does
  for (int i = 0; i < 100 && directory.file_count() == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  command.send_signal(SIGHUP);
  EXPECT_EQ(command.wait().exit_code, 0);
}
#endif

}  // namespace
}  // namespace polhode::demos
