#include "record/contender.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace polhode::demos {
namespace {

std::vector<std::string> names_of(const std::vector<Contender>& contenders) {
  std::vector<std::string> names(contenders.size());
  std::transform(contenders.begin(), contenders.end(), names.begin(),
                 [](const Contender& contender) { return contender.name; });
  return names;
}

TEST(Contenders, AreEveryRegisteredSchemeAndThenBulletsModesAndMultibody) {
  std::vector<std::string> expected;
  for (const SchemePointer& scheme : built_in_schemes()) expected.emplace_back(scheme->description().name);
  for (const char* own : {"none", "explicit", "implicit_world", "implicit_body", "multibody"}) {
    expected.push_back(std::string("bullet:") + own);
  }
  EXPECT_EQ(names_of(all_contenders()), expected);
  for (const Contender& contender : all_contenders())
    EXPECT_FALSE(contender.summary.empty()) << contender.name;
}

TEST(Contenders, AreTheExactOneTheHandoutsAndBulletsByDefault) {
  EXPECT_THAT(names_of(default_contenders()),
              testing::ElementsAre("exact", "matrix", "quaternion", "semi_implicit_gyroscopic",
                                   "implicit_gyroscopic", "bullet:none", "bullet:explicit",
                                   "bullet:implicit_world", "bullet:implicit_body"));
}

TEST(Contenders, KeepTheOrderTheyAreAskedForIn) {
  EXPECT_THAT(names_of(find_contenders({"bullet:none", "bullet:multibody", "matrix"})),
              testing::ElementsAre("bullet:none", "bullet:multibody", "matrix"));
}

TEST(Contenders, AreRefusedWithTheValidNamesOrWhenGivenTwice) {
  EXPECT_THAT(
      [] {
        find_contenders({"matrix", "cubic"});
      },
      testing::ThrowsMessage<std::invalid_argument>(
          testing::AllOf(testing::StartsWith("unknown contender \"cubic\"; valid are exact, matrix, "),
                         testing::EndsWith("bullet:implicit_body, bullet:multibody"))));
  EXPECT_THAT(
      [] {
        find_contenders({"matrix", "bullet:none", "matrix"});
      },
      testing::ThrowsMessage<std::invalid_argument>(
          "contender \"matrix\" is given twice; valid is each once"));
}

Scenario with_rotors() {
  Scenario scenario;
  scenario.body.drive.rotor_momentum_B = {0, 0, 1};
  return scenario;
}

TEST(Contenders, AreTheDefaultOnesThatTakeRotorsWhereThereAreSome) {
  const ChosenContenders chosen = chosen_contenders({}, with_rotors());
  EXPECT_THAT(names_of(chosen.contenders),
              testing::ElementsAre("exact", "quaternion", "semi_implicit_gyroscopic", "implicit_gyroscopic",
                                   "bullet:none", "bullet:explicit", "bullet:implicit_world",
                                   "bullet:implicit_body"));
  EXPECT_EQ(chosen.note, "left out, since they take no rotors: matrix");
  const ChosenContenders without = chosen_contenders({}, Scenario());
  EXPECT_EQ(names_of(without.contenders), names_of(default_contenders()));
  EXPECT_EQ(without.note, "");
}

TEST(Contenders, AreRefusedIfTheyAreNamedAndTakeNoRotors) {
  EXPECT_THAT(names_of(chosen_contenders({"matrix", "bullet:multibody"}, Scenario()).contenders),
              testing::ElementsAre("matrix", "bullet:multibody"));
  for (const char* name : {"matrix", "bullet", "moser_veselov", "moser_veselov_4", "bullet:multibody"}) {
    EXPECT_THAT(
        [&] {
          chosen_contenders({"exact", name}, with_rotors());
        },
        testing::ThrowsMessage<std::invalid_argument>(testing::AllOf(
            testing::StartsWith("contender \"" + std::string(name) +
                                "\" takes no rotors, and the scenario has some; valid are exact, quaternion"),
            testing::EndsWith("bullet:implicit_body"))));
  }
}

// The CSV files contain numbers and these names only. A spreadsheet reads neither as a formula, and no cell
// needs quotes.
TEST(Contenders, HaveNamesThatArePlainWords) {
  for (const Contender& contender : all_contenders()) {
    EXPECT_THAT(contender.name, testing::MatchesRegex("[a-z][a-z0-9_:]*"));
  }
}

}  // namespace
}  // namespace polhode::demos
