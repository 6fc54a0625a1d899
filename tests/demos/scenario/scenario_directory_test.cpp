#include "scenario/scenario_directory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "demos/support_files.h"
#include "scenario/json_file.h"

namespace polhode::demos {
namespace {

constexpr char kFreeBody[] = R"({"inertia": [1, 2, 3], "dt": 0.5, "duration": 10})";

class ScenarioDirectory : public testing::Test {
 protected:
  ScenarioDirectory() { look_in(directory_.path()); }
  ~ScenarioDirectory() override { ::unsetenv("POLHODE_SCENARIOS"); }

  static void look_in(const std::filesystem::path& directory) {
    ::setenv("POLHODE_SCENARIOS", directory.c_str(), 1);
  }

  TemporaryDirectory directory_;
};

TEST_F(ScenarioDirectory, ListsItsJsonFilesInOrder) {
  write_file(directory_ / "b.json", kFreeBody);
  write_file(directory_ / "a.json", kFreeBody);
  write_file(directory_ / "readme.md", "");
  EXPECT_THAT(scenario_names(), testing::ElementsAre("a", "b"));
  EXPECT_EQ(find_scenario("b").name, "b");
}

TEST_F(ScenarioDirectory, SaysWhichNamesAreValid) {
  write_file(directory_ / "a.json", kFreeBody);
  write_file(directory_ / "b.json", kFreeBody);
  EXPECT_THAT([] { find_scenario("c"); },
              testing::ThrowsMessage<ScenarioError>(
                  "unknown scenario \"c\"; valid are a, b, or a path to a .json file"));
}

TEST_F(ScenarioDirectory, IsNotSearchedForAFile) {
  const TemporaryDirectory elsewhere;
  write_file(elsewhere / "mine.json", kFreeBody);
  EXPECT_EQ(find_scenario((elsewhere / "mine.json").string()).name, "mine");
}

TEST_F(ScenarioDirectory, SaysThatItIsNotThere) {
  look_in(directory_ / "none");
  EXPECT_THAT([] { scenario_names(); }, testing::ThrowsMessage<ScenarioError>(
                                            testing::AllOf(testing::HasSubstr("none: no such directory"),
                                                           testing::HasSubstr("set POLHODE_SCENARIOS"))));
}

}  // namespace
}  // namespace polhode::demos
