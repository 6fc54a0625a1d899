#include "polhode/scheme_registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

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

// Markdown takes a bare | for the end of the cell.
std::string in_a_table_cell(std::string_view text) {
  std::string escaped;
  for (const char character : text) {
    if (character == '|') escaped += '\\';
    escaped += character;
  }
  return escaped;
}

TEST(SchemeRegistry, TheReadmesTableSaysWhatTheSchemesDeclare) {
  std::ifstream file(POLHODE_SOURCE_DIR "/plugin/README.md");
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
