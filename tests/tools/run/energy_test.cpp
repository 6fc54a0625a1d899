// The purpose of polhode-run: bodies keep their energy in a program that was not compiled for the library.
#include "tools/run/run_command.h"

namespace polhode::run_test {
namespace {

class ProgramRunWithRotation : public testing::TestWithParam<Host> {
 protected:
  static CommandResult run_host(const std::string& what) {
    return run({"--quiet", GetParam().program, what});
  }
};

TEST_P(ProgramRunWithRotation, KeepsTheEnergyThatItLosesAlone) {
  expect_energy_lost(run_plainly(GetParam().program, {"one"}));
  expect_energy_kept(run_host("one"), 1, GetParam().energy_tolerance);
}

TEST_P(ProgramRunWithRotation, KeepsTheEnergyOfEachWorld) {
  expect_energy_kept(run_host("two"), 2, GetParam().energy_tolerance);
}

TEST_P(ProgramRunWithRotation, KeepsTheEnergyOfWorldsAtTheAddressOfDeadOnes) {
  expect_energy_kept(run_host("remade"), 3, GetParam().energy_tolerance);
}

// Covers btSoftRigidDynamicsWorld, btMultiBodyDynamicsWorld, btSoftMultiBodyDynamicsWorld,
// btDiscreteDynamicsWorldMt.
TEST_P(ProgramRunWithRotation, KeepsTheEnergyInEachKindOfWorld) {
  expect_energy_lost(run_plainly(GetParam().program, {"kinds"}));
  expect_energy_kept(run_host("kinds"), 1, GetParam().energy_tolerance);
}

TEST_P(ProgramRunWithRotation, KeepsTheEnergyInSubsteps) {
  expect_energy_kept(run_host("substeps"), 1, GetParam().energy_tolerance);
}

TEST_P(ProgramRunWithRotation, KeepsTheEnergyOfWorldsAfterMain) {
  expect_energy_kept(run_host("after-main"), 2, GetParam().energy_tolerance);
}

TEST_P(ProgramRunWithRotation, KeepsTheEnergyWhereBulletIsLoadedLaterAndHidden) {
  expect_energy_lost(run_plainly(POLHODE_LOADING_HOST, {GetParam().hidden_worlds}));
  expect_energy_kept(run({"--quiet", POLHODE_LOADING_HOST, GetParam().hidden_worlds}), 1,
                     GetParam().energy_tolerance);
}

TEST_P(ProgramRunWithRotation, TakesTheSchemeThatIsAskedFor) {
  const CommandResult result = run({"--quiet", "--scheme", "bullet", GetParam().program, "one"});
  expect_energy_lost(result);
}

INSTANTIATE_TEST_SUITE_P(Precision, ProgramRunWithRotation, testing::ValuesIn(hosts()),
                         [](const auto& test) { return test.param.precision; });

TEST(BothPrecisionsInOneProgram, AreRotatedEach) {
  std::vector<std::string> words = {"--quiet", POLHODE_LOADING_HOST};
  for (const Host& host : hosts()) words.emplace_back(host.hidden_worlds);
  expect_energy_kept(run(words), hosts().size(), hosts().front().energy_tolerance);
}

}  // namespace
}  // namespace polhode::run_test
