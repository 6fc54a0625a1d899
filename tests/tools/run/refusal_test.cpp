// Errors that polhode-run reports before the program starts, in one line each.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "polhode/scheme_registry.h"
#include "tools/run/run_command.h"

namespace polhode::run_test {
namespace {

using testing::HasSubstr;

void expect_refusal(const CommandResult& result, int exit_code, const std::string& reason) {
  EXPECT_EQ(result.exit_code, exit_code);
  EXPECT_EQ(result.standard_output, "");
  EXPECT_THAT(result.standard_error, testing::MatchesRegex("polhode-run: [^\n]*\n"));
  EXPECT_THAT(result.standard_error, HasSubstr(reason));
}

TEST(RunRefuses, AnUnknownSchemeAndListsTheValidOnes) {
  expect_refusal(run({"--scheme", "rk5", "echo", "started"}), 2,
                 "--scheme: unknown rotation scheme \"rk5\": valid are " + scheme_names());
}

TEST(RunRefuses, AnUnknownOption) {
  expect_refusal(run({"--sheme", "rk4", "echo", "started"}), 2,
                 "--sheme: unknown option; valid options are --help");
}

TEST(RunRefuses, AMissingProgram) {
  expect_refusal(run({"--scheme", "rk4"}), 2, "PROGRAM: missing");
  expect_refusal(run({"--"}), 2, "PROGRAM: missing");
}

TEST(RunRefuses, AProgramThatIsNotFound) {
  expect_refusal(run({"polhode_no_such_program"}), 127, "polhode_no_such_program: no such program");
  expect_refusal(run({"./polhode_no_such_program"}), 127, "no such program");
}

TEST(RunRefuses, AFileThatCannotBeExecuted) {
  const demos::TemporaryDirectory directory;
  std::ofstream(directory / "file") << "text";
  expect_refusal(run({directory / "file"}), 126, "cannot be executed: Permission denied");
}

TEST(RunRefuses, AProgramThatHasBulletInIt) {
  EXPECT_EQ(run_plainly(POLHODE_STATIC_HOST, {}).exit_code, 7);
  expect_refusal(run({POLHODE_STATIC_HOST}), 2, "has Bullet linked into it statically");
}

TEST(RunRefuses, AProgramThatLoadsNoLibraries) {
  EXPECT_EQ(run_plainly(POLHODE_FULLY_STATIC_HOST, {}).exit_code, 0);
  expect_refusal(run({POLHODE_FULLY_STATIC_HOST}), 2,
                 "is linked statically, so nothing can be loaded into it");
}

TEST(RunRefuses, AnExecutableThatEndsInItsHeader) {
  const demos::TemporaryDirectory directory;
  const std::string file = directory / "file";
  std::ofstream(file) << "\177ELF\2";
  ::chmod(file.c_str(), 0700);
  expect_refusal(run({file}), 2, "is not a whole ELF file");
}

// The loader ignores LD_PRELOAD for such programs.
TEST(RunRefuses, AProgramThatRunsWithAnotherUsersRights) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can change the owner of a file";
  const demos::TemporaryDirectory directory;
  const std::string program = directory / "program";
  std::filesystem::copy_file(POLHODE_LOADING_HOST, program);
  constexpr uid_t kNobody = 65534;
  ASSERT_EQ(::chown(program.c_str(), kNobody, 0), 0);
  EXPECT_EQ(run({"--quiet", program}).exit_code, 0);
  ASSERT_EQ(::chmod(program.c_str(), 04755), 0);
  expect_refusal(run({program}), 2, "runs with another user's or group's rights");
}

TEST(RunRefuses, ToRunWithoutItsLibraries) {
  const demos::TemporaryDirectory directory;
  const std::string copy = directory / "polhode-run";
  std::filesystem::copy_file(POLHODE_RUN_EXECUTABLE, copy);
  expect_refusal(run_plainly(copy, {"echo", "started"}), 2,
                 "libpolhode_run.so: cannot be read: No such file");
}

TEST(RunRefuses, ASummaryThatCannotBeWritten) {
  expect_refusal(run({"--summary", "/proc/none", "echo", "started"}), 2,
                 "--summary: \"/proc/none\": cannot be written: ");
}

}  // namespace
}  // namespace polhode::run_test
