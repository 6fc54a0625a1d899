// docs/compare.md lists the columns of the CSV and the figures as the code defines them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "demos/support_files.h"
#include "record/figure_columns.h"
#include "record/quantities.h"

namespace polhode::demos {
namespace {

std::string page() {
  return read_file(POLHODE_COMPARE_PAGE);
}

std::string replaced(const std::string& text, const char* pattern, const char* with) {
  return std::regex_replace(text, std::regex(pattern), with);
}

TEST(Documentation, HasTheColumnsOfTheCsv) {
  std::string table = "| column | unit | meaning |\n|---|---|---|\n| `contender` | | |\n";
  for (const Quantity& quantity : quantities()) {
    if (!quantity.is_in_csv()) continue;
    table += "| `" + replaced(quantity.csv_columns, ",", "`, `") + "` | " + quantity.unit + " | " +
             quantity.meaning + " |\n";
  }
  EXPECT_THAT(page(), testing::HasSubstr("\n\n" + table + "\n"));
}

TEST(Documentation, HasTheFiguresOfTheTable) {
  std::string table = "| column | meaning |\n|---|---|\n";
  for (const FigureColumn& column : figure_columns()) {
    if (!column.is_in_table()) continue;
    const std::string row = replaced(column.heading, "\n", " ") + "\n" + column.meaning;
    table += "| " + replaced(replaced(row, "\\|", "\\|"), "\n", " | ") + " |\n";
  }
  EXPECT_THAT(page(), testing::HasSubstr("\n\n" + table + "\n"));
}

TEST(Documentation, HasTheFiguresOfTheJson) {
  std::string list = "Each contender has `name`";
  for (const FigureColumn& column : figure_columns()) list += std::string(", `") + column.key + "`";
  EXPECT_THAT(replaced(page(), "\\s+", " "), testing::HasSubstr(list + ":"));
}

}  // namespace
}  // namespace polhode::demos
