// Tests the summary that is printed when the program exits.
#include <unistd.h>

#include <filesystem>

#include "tools/run/run_command.h"

namespace polhode::run_test {
namespace {

using testing::HasSubstr;

class Summary : public testing::TestWithParam<Host> {
 protected:
  static std::string of(const std::string& what) { return run({GetParam().program, what}).standard_error; }
  static std::string worlds(const std::string& counts) {
    return "\n  worlds in " + std::string(GetParam().precision) + " precision: " + counts + "\n";
  }
};

TEST_P(Summary, CountsWorldsBodiesAndSteps) {
  const std::string summary = of("two");
  const std::string name = std::filesystem::path(GetParam().program).filename().string();
  EXPECT_THAT(summary,
              testing::MatchesRegex("polhode-run: " + name + " \\(process [0-9]+\\), scheme exact\n.*"));
  EXPECT_THAT(summary, HasSubstr(worlds("2 rotated, 0 left to Bullet")));
  EXPECT_THAT(summary, HasSubstr("\n  bodies, most in one world: 1 rigid body, 0 multibodies\n"));
  EXPECT_THAT(summary, HasSubstr("\n  steps: 1200\n"));
  EXPECT_THAT(summary, testing::EndsWith("\n  incidents: none\n"));
}

TEST_P(Summary, CountsWorldsAtOneAddress) {
  EXPECT_THAT(of("remade"), HasSubstr(worlds("3 rotated, 0 left to Bullet")));
}

TEST_P(Summary, CountsTheSubstepsThatWereTaken) {
  EXPECT_THAT(of("substeps"), HasSubstr("\n  steps: 1202\n"));
}

TEST_P(Summary, CountsMultibodies) {
  EXPECT_THAT(of("multibody"), HasSubstr(": 1 rigid body, 1 multibody\n"));
}

TEST_P(Summary, CountsIncidentsByKind) {
  EXPECT_THAT(of("non-finite"),
              HasSubstr("\n  incidents: 0 bodies whose scheme diverged, 1 body that was not finite\n"));
}

TEST_P(Summary, CountsWorldsThatAreLeftToBullet) {
  EXPECT_THAT(of("deformable"), HasSubstr(worlds("0 rotated, 1 left to Bullet")));
}

TEST_P(Summary, IsNotRepeatedByAForkedProcess) {
  const std::string summary = of("forked");
  EXPECT_THAT(summary, HasSubstr(worlds("1 rotated, 0 left to Bullet")));
  EXPECT_EQ(summary.find("polhode-run: "), summary.rfind("polhode-run: "));
}

TEST_P(Summary, OfEachProcessGoesToTheFileWhereverItsFolderIs) {
  const demos::TemporaryDirectory directory;
  const std::string program = std::string("'") + GetParam().program + "'";
  const std::string script = "cd / && " + program + " one && " + program + " two";
  const CommandResult result =
      demos::Command(POLHODE_RUN_EXECUTABLE, {"--summary", "file", "sh", "-c", script}, kEnvironment, [&] {
        if (::chdir(directory.path().c_str()) != 0) ::_exit(126);
      }).wait();
  EXPECT_EQ(result.standard_error, "");
  const std::string summary = demos::read_file(directory / "file");
  EXPECT_THAT(summary, HasSubstr(worlds("1 rotated, 0 left to Bullet")));
  EXPECT_THAT(summary, HasSubstr(worlds("2 rotated, 0 left to Bullet")));
}

TEST_P(Summary, HasNoControlCharacters) {
  const demos::TemporaryDirectory directory;
  const std::string name = directory / "a\033[2J\nb";
  std::filesystem::create_symlink(GetParam().program, name);
  EXPECT_THAT(run({name, "one"}).standard_error, testing::StartsWith("polhode-run: a?[2J?b (process "));
}

TEST_P(Summary, SaysWhyNoWorldWasSeen) {
  const CommandResult result = run({GetParam().program, "arguments"});
  EXPECT_THAT(result.standard_error, HasSubstr("no world was stepped in this process"));
  EXPECT_THAT(result.standard_error, HasSubstr("Bullet is linked statically"));
}

INSTANTIATE_TEST_SUITE_P(Precision, Summary, testing::ValuesIn(hosts()),
                         [](const auto& test) { return test.param.precision; });

}  // namespace
}  // namespace polhode::run_test
