// Programs without a writable output, a home, a display or a folder to write to.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "demos/faults/writers.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;

struct Printer {
  const char* name;
  const char* program;
  std::vector<std::string> arguments;
};

std::vector<Printer> printers() {
  std::vector<Printer> list;
#ifdef POLHODE_COMPARE_EXECUTABLE
  list.push_back({"ComparisonTable", POLHODE_COMPARE_EXECUTABLE, {"--contender", "exact"}});
  list.push_back({"ComparisonList", POLHODE_COMPARE_EXECUTABLE, {"--list"}});
  list.push_back({"ComparisonHelp", POLHODE_COMPARE_EXECUTABLE, {"--help"}});
  list.push_back({"ComparisonVersion", POLHODE_COMPARE_EXECUTABLE, {"--version"}});
#endif
#ifdef POLHODE_WORKPRECISION_EXECUTABLE
  const std::vector<std::string> cost = {"cost", "--rounds", "1", "--contender", "exact"};
  list.push_back({"Costs", POLHODE_WORKPRECISION_EXECUTABLE, cost});
  list.push_back({"WorkPrecisionHelp", POLHODE_WORKPRECISION_EXECUTABLE, {"map", "--help"}});
#endif
#ifdef POLHODE_VIEWER_EXECUTABLE
  list.push_back({"ViewerHelp", POLHODE_VIEWER_EXECUTABLE, {"--help"}});
  list.push_back({"ViewerVersion", POLHODE_VIEWER_EXECUTABLE, {"--version"}});
#endif
  return list;
}

class StandardOutput : public testing::TestWithParam<Printer> {
 protected:
  static CommandResult run(const std::function<void()>& prepare) {
    return Command(GetParam().program, GetParam().arguments, kWithoutDisplay, prepare).wait();
  }
  static void expect_refusal(const CommandResult& result, const std::string& reason) {
    expect_refused_in_one_line(result);
    EXPECT_THAT(result.standard_error,
                testing::EndsWith(": standard output cannot be written: " + reason + "\n"));
  }
};

TEST_P(StandardOutput, ThatIsFullIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const CommandResult result = run([] { ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO); });
  expect_refusal(result, "No space left on device");
}

TEST_P(StandardOutput, ThatIsClosedIsReported) {
  expect_refusal(run([] { ::close(STDOUT_FILENO); }), "Bad file descriptor");
}

TEST_P(StandardOutput, ThatNobodyReadsEndsTheProgram) {
  const auto without_reader = [] {
    int ends[2];
    if (::pipe(ends) != 0) ::_exit(126);
    ::dup2(ends[1], STDOUT_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
  };
  EXPECT_EQ(run(without_reader).exit_code, -SIGPIPE);
  const CommandResult result = run([&] {
    without_reader();
    std::signal(SIGPIPE, SIG_IGN);
  });
  expect_refusal(result, "Broken pipe");
}

INSTANTIATE_TEST_SUITE_P(Demos, StandardOutput, testing::ValuesIn(printers()),
                         [](const auto& test) { return test.param.name; });

class Surroundings : public WriterTest {};

// Not even root can write to it.
constexpr char kUnwritable[] = "/proc";

TEST_P(Surroundings, WithoutAHomeAndAFolderToWriteToAreEnough) {
  if (!std::filesystem::exists(kUnwritable)) GTEST_SKIP() << "no /proc";
  for (const bool has_home : {false, true}) {
    const CommandResult result =
        start([&] {
          for (const char* name : {"HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_RUNTIME_DIR"})
            ::unsetenv(name);
          if (has_home) ::setenv("HOME", kUnwritable, 1);
          if (::chdir(kUnwritable) != 0) ::_exit(126);
        }).wait();
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.standard_error, "");
    EXPECT_GT(read_file(target()).size(), 0u);
  }
}

TEST_P(Surroundings, WithoutAFolderToWriteToAreNamed) {
  if (!std::filesystem::exists(kUnwritable)) GTEST_SKIP() << "no /proc";
  const std::string file = "polhode_out";
  const CommandResult result = start_with(file, [] {
                                 if (::chdir(kUnwritable) != 0) ::_exit(126);
                               }).wait();
  expect_refused_in_one_line(result);
  EXPECT_THAT(result.standard_error, HasSubstr("\"" + file + "\": cannot be written: "));
}

INSTANTIATE_TEST_SUITE_P(Demos, Surroundings, testing::ValuesIn(writers()), name_of);

#ifdef POLHODE_VIEWER_EXECUTABLE
TEST(ViewerWithoutADisplay, SaysSo) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{}, {"--through-window", "--screenshot", "/tmp/polhode_never.png"}}) {
    const CommandResult result = Command(POLHODE_VIEWER_EXECUTABLE, arguments, kWithoutDisplay).wait();
    expect_refused_in_one_line(result);
    EXPECT_THAT(result.standard_error, HasSubstr("no window can be opened"));
    EXPECT_THAT(result.standard_error, HasSubstr("without a display valid is --screenshot FILE.png"));
  }
}
#endif

}  // namespace
}  // namespace polhode::demos
