#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "demos/compare/command.h"

namespace polhode::demos {

/// polhode_workprecision as a process, which is to succeed in silence.
inline CommandResult work_precision(const std::vector<std::string>& arguments) {
  CommandResult result = Command(POLHODE_WORKPRECISION_EXECUTABLE, arguments).wait();
  EXPECT_EQ(result.exit_code, 0) << result.standard_error;
  EXPECT_EQ(result.standard_error, "");
  return result;
}

/// Expects that demos/README.md names each column of a CSV's first line.
inline void expect_documented_columns(const std::string& csv) {
  const std::string readme = read_file(POLHODE_DEMOS_README);
  std::string header = csv.substr(0, csv.find('\n'));
  for (std::size_t comma = 0; comma != std::string::npos;) {
    comma = header.find(',');
    const std::string column = header.substr(0, comma);
    EXPECT_NE(readme.find("`" + column + "`"), std::string::npos) << column;
    if (comma != std::string::npos) header.erase(0, comma + 1);
  }
}

}  // namespace polhode::demos
