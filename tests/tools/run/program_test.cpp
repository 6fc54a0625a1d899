// polhode-run preserves the program's arguments, output, exit code, signals and exceptions.
#include <csignal>

#include "tools/run/run_command.h"

namespace polhode::run_test {
namespace {

using testing::HasSubstr;

class ProgramUnderRun : public testing::TestWithParam<Host> {};

TEST_P(ProgramUnderRun, GetsAllArgumentsAfterItsName) {
  const CommandResult result =
      run({"--quiet", GetParam().program, "arguments", "--scheme", "--quiet", "--", "a b"});
  EXPECT_EQ(result.standard_output, "[--scheme][--quiet][--][a b]");
  EXPECT_EQ(result.exit_code, 0);
}

TEST_P(ProgramUnderRun, MayFollowTwoDashes) {
  EXPECT_EQ(run({"--quiet", "--", GetParam().program, "arguments", "a"}).standard_output, "[a]");
}

TEST_P(ProgramUnderRun, HasItsExitCode) {
  EXPECT_EQ(run({GetParam().program, "exit-3"}).exit_code, 3);
}

TEST_P(ProgramUnderRun, EndsByASignalWithoutASummary) {
  const CommandResult result = run({GetParam().program, "killed"});
  EXPECT_EQ(result.exit_code, -SIGTERM);
  EXPECT_EQ(result.standard_error, "");
}

TEST_P(ProgramUnderRun, MayThrowThroughAStep) {
  const CommandResult result = run({GetParam().program, "throwing"});
  EXPECT_EQ(result.standard_output, "caught: from a tick callback\n");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.standard_error, HasSubstr("1 rotated"));
}

TEST_P(ProgramUnderRun, PrintsNothingMoreIfQuiet) {
  EXPECT_EQ(run({"--quiet", GetParam().program, "one"}).standard_error, "");
}

// Bit-identical: Bullet itself steps the world.
TEST_P(ProgramUnderRun, HasADeformableWorldLeftToBullet) {
  const CommandResult result = run({"--quiet", GetParam().program, "deformable"});
  EXPECT_EQ(result.standard_output, run_plainly(GetParam().program, {"deformable"}).standard_output);
  EXPECT_THAT(
      result.standard_error,
      testing::MatchesRegex("polhode-run: a btDeformableMultiBodyDynamicsWorld is left to Bullet: [^\n]*\n"));
}

TEST_P(ProgramUnderRun, HasAWorldWithItsOwnIslandManagerLeftToBullet) {
  const CommandResult result = run({"--quiet", GetParam().program, "own-islands"});
  expect_energy_lost(result);
  EXPECT_THAT(result.standard_error,
              testing::MatchesRegex(
                  "polhode-run: a [^\n]*WorldWithOwnIslands is left to Bullet: the island [^\n]*\n"));
}

TEST_P(ProgramUnderRun, MayReplaceTheIslandManagerLater) {
  const CommandResult result = run({GetParam().program, "own-islands-later"});
  EXPECT_EQ(result.exit_code, 0);
  expect_energy_lost(result);
  EXPECT_THAT(result.standard_error, HasSubstr("the program has replaced the world's island manager\n"));
  EXPECT_THAT(result.standard_error, HasSubstr("1 rotated, 1 left to Bullet\n"));
}

// Each of the two Bullets keeps its own function.
TEST_P(ProgramUnderRun, MayLoadALibraryThatHasBulletInItBesides) {
  const CommandResult result = run({POLHODE_LOADING_HOST, GetParam().hidden_worlds, POLHODE_OTHER_PLUGIN});
  const std::vector<double> ratios = energy_ratios(result);
  ASSERT_EQ(ratios.size(), 2u) << result.standard_error;
  EXPECT_LT(std::abs(ratios[0] - 1.0), GetParam().energy_tolerance);
  EXPECT_EQ(ratios[1], 7.0);
  EXPECT_THAT(result.standard_error, HasSubstr(": 1 rotated, 0 left to Bullet\n"));
  EXPECT_THAT(result.standard_error, HasSubstr("in single precision: 2 calls of stepSimulation\n"));
}

INSTANTIATE_TEST_SUITE_P(Precision, ProgramUnderRun, testing::ValuesIn(hosts()),
                         [](const auto& test) { return test.param.precision; });

#ifdef POLHODE_ROTATING_HOST
class ProgramThatRotatesItself : public testing::TestWithParam<const char*> {};

TEST_P(ProgramThatRotatesItself, IsLeftAlone) {
  const CommandResult result = run({"--quiet", POLHODE_ROTATING_HOST, GetParam()});
  EXPECT_EQ(result.standard_output, run_plainly(POLHODE_ROTATING_HOST, {GetParam()}).standard_output);
  EXPECT_THAT(result.standard_error,
              testing::EndsWith("the program itself rotates the bodies of this world by polhode\n"));
}

INSTANTIATE_TEST_SUITE_P(By, ProgramThatRotatesItself, testing::Values("world", "derived", "plugin"),
                         [](const auto& test) { return test.param; });
#endif

TEST(ProgramWithAnotherBullet, RunsWithAMessageThatNamesTheBulletFound) {
  const CommandResult result = run({POLHODE_OTHER_HOST});
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_THAT(
      result.standard_error,
      HasSubstr(
          "single-precision Bullet is in libBulletDynamics.so.2.88, and expected is libBulletDynamics"));
  EXPECT_THAT(result.standard_error,
              HasSubstr("left alone in single precision: 2 calls of stepSimulation\n"));
}

}  // namespace
}  // namespace polhode::run_test
