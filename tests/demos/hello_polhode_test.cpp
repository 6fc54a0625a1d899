#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "demos/compare/command.h"

namespace polhode::demos {
namespace {

TEST(HelloPolhode, TumblesAtConstantMomentumAndComesToRest) {
  const CommandResult result = Command(POLHODE_HELLO_EXECUTABLE, {}).wait();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.standard_error, "");
  EXPECT_THAT(result.standard_output, testing::HasSubstr("t 0.75 s"));
  const auto count = [&](const std::string& text) {
    int found = 0;
    for (std::size_t at = 0; (at = result.standard_output.find(text, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("|L| 0.6935 kg"), 4) << "in free fall\n" << result.standard_output;
  EXPECT_GE(count("height  0.100 m"), 4) << "at rest on its face\n" << result.standard_output;
}

}  // namespace
}  // namespace polhode::demos
