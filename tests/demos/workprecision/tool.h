#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "demos/compare/command.h"

namespace polhode::demos {

/// Runs polhode_workprecision. Expects success and nothing on stderr.
inline CommandResult work_precision(const std::vector<std::string>& arguments) {
  CommandResult result = Command(POLHODE_WORKPRECISION_EXECUTABLE, arguments).wait();
  EXPECT_EQ(result.exit_code, 0) << result.standard_error;
  EXPECT_EQ(result.standard_error, "");
  return result;
}

/// Expects that docs/work_precision.md names each column of a CSV's first line.
inline void expect_documented_columns(const std::string& csv) {
  const std::string page = read_file(POLHODE_WORKPRECISION_PAGE);
  std::string header = csv.substr(0, csv.find('\n'));
  for (std::size_t comma = 0; comma != std::string::npos;) {
    comma = header.find(',');
    const std::string column = header.substr(0, comma);
    EXPECT_NE(page.find("`" + column + "`"), std::string::npos) << column;
    if (comma != std::string::npos) header.erase(0, comma + 1);
  }
}

}  // namespace polhode::demos
