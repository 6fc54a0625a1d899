// Bad input of polhode_compare gives exit code 2, one line on stderr that says what is valid, and no file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "demos/compare/command.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;

struct BadInput {
  std::string what;
  std::vector<std::string> arguments;  ///< DIR stands for the test's directory
  std::string valid;                   ///< what the message must contain
};

std::ostream& operator<<(std::ostream& stream, const BadInput& input) {
  return stream << input.what;
}

class BadInputOfCompare : public testing::TestWithParam<BadInput> {
 protected:
  std::string in_directory(std::string text) const {
    const std::size_t at = text.find("DIR");
    return at == std::string::npos ? text : text.replace(at, 3, directory_.path().string());
  }

  TemporaryDirectory directory_;
};

TEST_P(BadInputOfCompare, IsRefusedInOneLineWithNoFileLeft) {
  write_file(directory_ / "bad.json", R"({"inertia": [1, 2, "x"], "dt": 1, "duration": 2})");
  write_file(directory_ / "fast.json", R"({"inertia": [1e-9, 1, 1], "dt": 1, "duration": 2,
                                           "impulses": [{"impulse": [0, 0, 1e9], "at": [0, 1, 0]}]})");
  std::vector<std::string> arguments;
  arguments.reserve(GetParam().arguments.size());
  for (const std::string& argument : GetParam().arguments) arguments.push_back(in_directory(argument));
  const int files_before = directory_.file_count();

  const CommandResult result = Command(POLHODE_COMPARE_EXECUTABLE, arguments).wait();

  expect_refused_in_one_line(result);
  EXPECT_EQ(result.standard_output, "");
  EXPECT_EQ(result.standard_error.back(), '\n');
  EXPECT_THAT(result.standard_error, testing::StartsWith("polhode_compare"));
  EXPECT_THAT(result.standard_error, HasSubstr(in_directory(GetParam().valid)));
  EXPECT_EQ(directory_.file_count(), files_before);
}

const std::string kDt = "--dt: must be a finite number between 1e-06 and 1000, is ";
const std::string kDuration = "--duration: must be a finite number between 1e-06 and 1e+11, is ";
const std::string kOptions =
    "valid options are -h,--help, --version, --list, --scenario, --contender, --scheme-library, --dt, "
    "--duration, --csv, --json, --report";
const std::string kFile = "valid is a file in an existing, writable directory";

const BadInput kBadInputs[] = {
    {"unknown_option", {"--frobnicate"}, kOptions},
    {"stray_word", {"tumble"}, kOptions},
    {"option_without_value", {"--csv"}, kOptions},
    {"scenario_twice", {"--scenario", "tumble", "--scenario", "floor"}, kOptions},
    {"unknown_scenario",
     {"--scenario", "tumbler", "--csv", "DIR/out.csv"},
     "valid are bicycle_wheel, cube_expansion, dzhanibekov, explorer_1, fast_spinner, floor, "
     "gravity_gradient, "
     "heavy_top, osrf_boxes, osrf_boxes_simple, reaction_wheels, t_handle, tumble, wheel_stops_the_flip, or "
     "a "
     "path"},
    {"empty_scenario", {"--scenario", ""}, "valid are bicycle_wheel, cube_expansion,"},
    {"line_break_in_a_name", {"--scenario", "a\nb"}, "valid are bicycle_wheel, cube_expansion,"},
    {"contender_without_rotors",
     {"--scenario", "bicycle_wheel", "--contender", "exact", "--contender", "matrix", "--csv", "DIR/out.csv"},
     "contender \"matrix\" takes no rotors, and the scenario has some; valid are exact, quaternion"},
    {"multibody_without_rotors",
     {"--scenario", "explorer_1", "--contender", "bullet:multibody"},
     "contender \"bullet:multibody\" takes no rotors"},
    {"missing_file",
     {"--scenario", "DIR/none.json"},
     "DIR/none.json: no such file; a scenario is a JSON file"},
    {"directory_for_a_scenario",
     {"--scenario", "DIR/"},
     "neither a regular file nor a pipe; a scenario is a JSON file"},
    {"bad_scenario",
     {"--scenario", "DIR/bad.json", "--csv", "DIR/out.csv", "--json", "DIR/out.json"},
     "DIR/bad.json: \"inertia[2]\": must be a finite number between 1e-12 and 1e+09, is \"x\""},
    {"start_too_fast",
     {"--scenario", "DIR/fast.json", "--csv", "DIR/out.csv"},
     "DIR/fast.json: \"angular_velocity\", \"linear_velocity\", \"impulses\": together they make 1e+18 rad/s "
     "or m/s; valid is at most 1e+09"},
    {"unknown_contender",
     {"--contender", "cubic", "--json", "DIR/out.json"},
     "valid are exact, matrix, quaternion, semi_implicit_gyroscopic, implicit_gyroscopic, bullet, "},
    {"second_word_after_contender", {"--contender", "matrix", "quaternion"}, kOptions},
    {"contender_twice", {"--contender", "matrix", "--contender", "matrix"}, "valid is each once"},
    {"dt_no_number", {"--dt", "fast"}, kDt + "\"fast\""},
    {"dt_with_comma", {"--dt", "0,5"}, kDt + "\"0,5\""},
    {"dt_nan", {"--dt", "nan"}, kDt + "\"nan\""},
    {"dt_infinite", {"--dt", "inf"}, kDt + "\"inf\""},
    {"dt_zero", {"--dt", "0"}, kDt + "\"0\""},
    {"dt_negative", {"--dt", "-0.1"}, kDt + "\"-0.1\""},
    {"dt_too_small_for_bullet", {"--dt", "1e-7"}, kDt + "\"1e-7\""},
    {"duration_overflowing", {"--duration", "1e999"}, kDuration + "\"1e999\""},
    {"duration_zero", {"--duration", "0"}, kDuration + "\"0\""},
    {"less_than_a_step",
     {"--dt", "1", "--duration", "0.5"},
     "dzhanibekov: duration / dt must be between 1 and 1e+08 steps, is 0.5 s / 1 s = 0.5"},
    {"too_many_steps", {"--dt", "1e-6", "--duration", "1e6"}, "must be between 1 and 1e+08 steps"},
    {"csv_in_no_directory", {"--csv", "DIR/none/out.csv"}, kFile},
    {"csv_on_a_directory", {"--csv", "DIR"}, kFile},
    {"csv_on_a_device", {"--csv", "/dev/null"}, kFile},
    {"csv_without_a_name", {"--csv", ""}, kFile},
    {"json_in_no_directory", {"--csv", "DIR/out.csv", "--json", "DIR/none/out.json"}, kFile},
    {"report_in_no_directory", {"--csv", "DIR/out.csv", "--report", "DIR/none/out.html"}, kFile},
    {"report_and_csv_the_same", {"--csv", "DIR/out", "--report", "DIR/out"}, "--csv and --report: both are"},
    {"both_files_the_same", {"--csv", "DIR/out", "--json", "DIR/./out"}, "valid are two files"}};

INSTANTIATE_TEST_SUITE_P(Each, BadInputOfCompare, testing::ValuesIn(kBadInputs),
                         [](const auto& input) { return input.param.what; });

TEST(BadInput, InTheScenarioDirectoryIsRefusedToo) {
  const CommandResult result =
      Command(POLHODE_COMPARE_EXECUTABLE, {"--list"}, {"POLHODE_SCENARIOS=/nowhere/at/all"}).wait();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(
      result.standard_error,
      HasSubstr(
          "/nowhere/at/all: no such directory; set POLHODE_SCENARIOS to the one with the scenario files"));
}

}  // namespace
}  // namespace polhode::demos
