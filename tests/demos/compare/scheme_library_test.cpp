// Schemes from libraries run beside the built-in ones: demos/hello_scheme.cpp, and libraries that are
// refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

#include "demos/compare/command.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;

CommandResult compare_with(const std::vector<std::string>& arguments) {
  return Command(POLHODE_COMPARE_EXECUTABLE, arguments).wait();
}

double attitude_error(const std::string& dt) {
  const TemporaryDirectory directory;
  const CommandResult result =
      compare_with({"--scheme-library", POLHODE_HELLO_SCHEME, "--scenario", "tumble", "--contender",
                    "explicit_midpoint", "--dt", dt, "--json", (directory / "out.json").string()});
  EXPECT_EQ(result.exit_code, 0) << result.standard_error;
  const nlohmann::json json = nlohmann::json::parse(read_file(directory / "out.json"));
  return json["contenders"][0]["final_attitude_error_rad"];
}

TEST(SchemeLibrary, ShowsItsSchemeAmongTheDefaultContendersAndInTheList) {
  EXPECT_THAT(compare_with({"--scheme-library", POLHODE_HELLO_SCHEME, "--duration", "0.3"}).standard_output,
              HasSubstr("\nexplicit_midpoint "));
  EXPECT_THAT(compare_with({"--scheme-library", POLHODE_HELLO_SCHEME, "--list"}).standard_output,
              HasSubstr("\nexplicit_midpoint "));
}

TEST(SchemeLibrary, HasASchemeOfTheOrderItDeclares) {
  // measured 4.03
  EXPECT_NEAR(attitude_error("0.001") / attitude_error("0.0005"), 4.0, 0.1);
}

TEST(SchemeLibrary, IsFoundFromTheWorkingDirectory) {
  const std::string relative =
      std::filesystem::relative(POLHODE_HELLO_SCHEME, std::filesystem::current_path()).string();
  EXPECT_EQ(compare_with({"--scheme-library", relative, "--list"}).exit_code, 0);
}

struct Refused {
  std::string file;
  std::string reason;
};

std::ostream& operator<<(std::ostream& stream, const Refused& refused) {
  return stream << refused.reason.substr(0, refused.reason.find(" ", 20));
}

class RefusedSchemeLibrary : public testing::TestWithParam<Refused> {};

TEST_P(RefusedSchemeLibrary, IsNamedWithTheReason) {
  const CommandResult result = compare_with({"--scheme-library", GetParam().file});
  expect_refused_in_one_line(result);
  EXPECT_THAT(result.standard_error,
              HasSubstr("scheme library " + GetParam().file + ": " + GetParam().reason));
}

INSTANTIATE_TEST_SUITE_P(
    , RefusedSchemeLibrary,
    testing::Values(
        Refused{"/no/such.so", "cannot be loaded"}, Refused{"/", "cannot be loaded"},
        Refused{__FILE__, "cannot be loaded"},
        Refused{POLHODE_LIBRARY_WITHOUT_SCHEMES,
                "is not a library of rotation schemes; valid is one made with POLHODE_SCHEME_LIBRARY"},
        Refused{POLHODE_OTHER_VERSION, "was compiled for polhode 0.99; valid is 0."},
        Refused{POLHODE_BUILT_IN_NAME, "the rotation scheme \"rk4\" is built in: choose another name"}));

}  // namespace
}  // namespace polhode::demos
