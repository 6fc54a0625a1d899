#include "polhode/scheme_registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace polhode {
namespace {

using ::testing::HasSubstr;

TEST(SchemeRegistry, FindsEverySchemeByTheNameItDeclares) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    EXPECT_EQ(find_scheme(scheme->description().name), scheme);
  }
}

TEST(SchemeRegistry, HoldsTheHandoutsFourTheControlAndTheGallery) {
  for (const char* name :
       {"matrix", "quaternion", "semi_implicit_gyroscopic", "implicit_gyroscopic", "bullet", "rk4",
        "axis_splitting", "implicit_midpoint", "moser_veselov", "moser_veselov_4"}) {
    EXPECT_NO_THROW(find_scheme(name)) << name;
  }
}

TEST(SchemeRegistry, NamesAreUniqueAndDescriptionsComplete) {
  std::set<std::string_view> names;
  for (const SchemePointer& scheme : built_in_schemes()) {
    const SchemeDescription description = scheme->description();
    EXPECT_TRUE(names.insert(description.name).second) << description.name;
    EXPECT_FALSE(description.summary.empty() || description.source.empty() || description.fails_when.empty());
    EXPECT_GE(description.order.value_or(1), 1);
  }
}

TEST(SchemeRegistry, UnknownNameIsRefusedWithTheValidOnes) {
  try {
    find_scheme("quaternoin");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("\"quaternoin\""));
    EXPECT_THAT(
        error.what(),
        HasSubstr("exact, matrix, quaternion, semi_implicit_gyroscopic, implicit_gyroscopic, bullet, rk4, "
                  "axis_splitting, implicit_midpoint, moser_veselov, moser_veselov_4"));
  }
}

TEST(SchemeRegistry, TheDefaultIsOneOfThem) {
  EXPECT_EQ(find_scheme(default_scheme()->description().name), default_scheme());
}

class NamedScheme final : public RotationScheme {
 public:
  explicit NamedScheme(std::string name) : name_(std::move(name)) {}
  SchemeDescription description() const noexcept override {
    return {name_, "stands still", "this test", "anything turns"};
  }
  void step(const StepInput& /*input*/, RotationState& /*state*/) const noexcept override {}

 private:
  std::string name_;
};

std::string refusal_of(SchemePointer scheme) {
  try {
    register_scheme(std::move(scheme));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "registered";
}

TEST(RegisteredScheme, IsFoundByItsName) {
  const auto scheme = std::make_shared<NamedScheme>("registered_1");
  register_scheme(scheme);
  EXPECT_EQ(find_scheme("registered_1"), scheme);
  EXPECT_THAT(scheme_names(), HasSubstr(", registered_1"));
  EXPECT_EQ(all_schemes().front(), built_in_schemes().front());
}

TEST(RegisteredScheme, ReplacesTheOneOfItsNameInItsPlace) {
  const auto first = std::make_shared<NamedScheme>("replaced");
  register_scheme(first);
  register_scheme(std::make_shared<NamedScheme>("after_replaced"));
  const std::vector<SchemePointer> before = all_schemes();
  const auto second = std::make_shared<NamedScheme>("replaced");
  register_scheme(second);
  EXPECT_EQ(find_scheme("replaced"), second);
  const std::vector<SchemePointer> after = all_schemes();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_EQ(after[i], before[i] == first ? second : before[i]) << i;
  EXPECT_EQ(first.use_count(), 2);  // held by `before`, not by the registry any more
}

TEST(RegisteredScheme, CannotTakeTheNameOfABuiltInOne) {
  EXPECT_THAT(refusal_of(std::make_shared<NamedScheme>("exact")),
              HasSubstr("\"exact\" is built in: choose another name"));
  EXPECT_EQ(find_scheme("exact"), default_scheme());
}

TEST(RegisteredScheme, NeedsANameThatCommandLinesAndFilesTake) {
  for (const char* name : {"", "Upper", "with space", "bullet:mine", "1st", "_x", "tab\t", "\xc3\xa9"}) {
    EXPECT_THAT(refusal_of(std::make_shared<NamedScheme>(name)),
                HasSubstr("valid are lower-case letters, digits and underscores, starting with a letter"))
        << name;
  }
  EXPECT_THAT(refusal_of(nullptr), HasSubstr("null pointer"));
}

TEST(RegisteredScheme, MayComeFromAnyThread) {
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([thread] {
      for (int i = 0; i < 200; ++i) {
        const std::string name = "thread_" + std::to_string(thread) + "_" + std::to_string(i);
        const auto scheme = std::make_shared<NamedScheme>(name);
        register_scheme(scheme);
        EXPECT_EQ(find_scheme(name), scheme);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

// Escapes | characters, which would end a cell in Markdown.
std::string in_a_table_cell(std::string_view text) {
  std::string escaped;
  for (const char character : text) {
    if (character == '|') escaped += '\\';
    escaped += character;
  }
  return escaped;
}

TEST(SchemeRegistry, TheTableOfSchemesSaysWhatTheyDeclare) {
  std::ifstream file(POLHODE_SOURCE_DIR "/docs/schemes.md");
  ASSERT_TRUE(file.good());
  std::ostringstream readme;
  readme << file.rdbuf();
  for (const SchemePointer& scheme : built_in_schemes()) {
    const SchemeDescription description = scheme->description();
    std::ostringstream row;
    row << "| `" << description.name << "` | " << order_text(description.order) << " | "
        << to_string(description.energy) << " | " << to_string(description.angular_momentum) << " | "
        << to_string(description.rotation) << " | " << in_a_table_cell(description.fails_when) << " | "
        << description.source << " |";
    EXPECT_THAT(readme.str(), HasSubstr(row.str()));
  }
}

}  // namespace
}  // namespace polhode
