// Bad input of polhode_workprecision gives exit code 2, one line on stderr that says what is valid, and no
// file.
#include <gmock/gmock.h>

#include "demos/workprecision/tool.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;

struct BadOptions {
  std::string what;
  std::vector<std::string> arguments;  ///< DIR stands for the test's directory
  std::string valid;                   ///< what the message must contain
};

std::ostream& operator<<(std::ostream& stream, const BadOptions& options) {
  return stream << options.what;
}

class BadOptionsOfWorkPrecision : public testing::TestWithParam<BadOptions> {
 protected:
  TemporaryDirectory directory_;
};

TEST_P(BadOptionsOfWorkPrecision, AreRefusedInOneLineWithNoFileLeft) {
  std::vector<std::string> arguments = GetParam().arguments;
  for (std::string& argument : arguments) {
    if (argument.rfind("DIR", 0) == 0) argument.replace(0, 3, directory_.path().string());
  }
  const CommandResult result = Command(POLHODE_WORKPRECISION_EXECUTABLE, arguments).wait();
  expect_refused_in_one_line(result);
  EXPECT_EQ(result.standard_output, "");
  EXPECT_THAT(result.standard_error, testing::StartsWith("polhode_workprecision"));
  EXPECT_THAT(result.standard_error, HasSubstr(GetParam().valid));
  EXPECT_EQ(directory_.file_count(), 0);
}

const std::string kFile = "valid is a file in an existing, writable directory";

const BadOptions kBadOptions[] = {
    {"nothing", {}, "valid subcommands are curve, cost, map, joints"},
    {"unknown_subcommand", {"graph"}, "valid subcommands are curve, cost, map, joints"},
    {"unknown_option",
     {"cost", "--frobnicate"},
     "valid options are -h,--help, --scheme-library, --inertia, --omega"},
    {"unknown_contender", {"cost", "--contender", "cubic"}, "unknown contender \"cubic\"; valid are "},
    {"terminal_escapes",
     {"cost", "--contender", "\x1b[2J\u202e\xff\n"},
     "\"\\x1b[2J\\xe2\\x80\\xae\\xff\\x0a\""},
    {"contender_twice", {"cost", "--contender", "rk4", "--contender", "rk4"}, "valid is each once"},
    {"two_moments", {"curve", "--inertia", "1", "2"}, "valid options are"},
    {"moment_zero",
     {"curve", "--inertia", "1", "0", "2"},
     "--inertia: must be a finite number between 1e-12"},
    {"spin_with_comma", {"curve", "--omega", "1", "0,5", "2"}, "is \"0,5\""},
    {"no_spin", {"curve", "--omega", "0", "0", "0"}, "valid is a body that spins"},
    {"half_a_level", {"curve", "--levels", "2.5"}, "--levels: must be a whole number between 1 and 30"},
    {"too_many_steps", {"curve", "--time", "1e8"}, "more than 1e+08 steps"},
    {"less_than_a_step", {"curve", "--time", "0.01"}, "--time: is less than one step"},
    {"scenario_with_torque",
     {"curve", "--scenario", "heavy_top"},
     "heavy_top: not a free body; valid is one"},
    {"unknown_scenario", {"curve", "--scenario", "tumbler"}, "valid are bicycle_wheel, cube_expansion,"},
    {"scenario_and_body", {"curve", "--scenario", "tumble", "--omega", "1", "2", "3"}, "excludes"},
    {"curve_in_no_directory", {"curve", "--csv", "DIR/none/out.csv"}, kFile},
    {"both_files_the_same", {"cost", "--csv", "DIR/out", "--json", "DIR/./out"}, "valid are two files"},
    {"map_without_a_file", {"map"}, "valid are --csv FILE, --json FILE or both"},
    {"map_in_no_directory", {"map", "--csv", "DIR/none/out.csv"}, kFile},
    {"map_on_a_directory", {"map", "--csv", "DIR"}, kFile},
    {"falling_axis", {"map", "--csv", "DIR/out", "--omega-dt", "2", "1", "9"}, "valid is FROM less than TO"},
    {"ratio_under_one",
     {"map", "--csv", "DIR/out", "--inertia-ratio", "0.5", "2", "9"},
     "--inertia-ratio: must be a finite number between 1 and"},
    {"no_steps", {"map", "--csv", "DIR/out", "--steps", "0"}, "--steps: must be a whole number between 1"},
    {"unknown_start", {"map", "--csv", "DIR/out", "--start", "up"}, "valid are middle_axis, generic"},
    {"joints_without_a_file", {"joints"}, "joints writes files; valid are --csv FILE, --json FILE or both"},
    {"joints_in_no_directory", {"joints", "--csv", "DIR/none/out.csv"}, kFile},
    {"mode_of_bullet_as_scheme",
     {"joints", "--csv", "DIR/out", "--scheme", "bullet:none"},
     "unknown rotation scheme \"bullet:none\": valid are "},
    {"multibody_in_joints_of_rigid_bodies",
     {"joints", "--csv", "DIR/out", "--scheme", "bullet:multibody"},
     "unknown rotation scheme \"bullet:multibody\": valid are "},
    {"scheme_twice",
     {"joints", "--csv", "DIR/out", "--scheme", "rk4", "--scheme", "rk4"},
     "valid is each once"},
    {"unknown_kind",
     {"joints", "--csv", "DIR/out", "--kind", "slider"},
     "--kind: is \"slider\"; valid are hinge, motor, weld, point, lock, spring"},
    {"kind_twice", {"joints", "--csv", "DIR/out", "--kind", "weld", "--kind", "weld"}, "valid is each once"},
    {"half_a_turn_in_a_step",
     {"joints", "--csv", "DIR/out", "--omega-dt", "1", "3.2", "9"},
     "--omega-dt: must be a finite number between 1e-04 and 3.1"},
    {"tilt_below_zero",
     {"joints", "--csv", "DIR/out", "--tilt", "-0.1", "1", "9"},
     "--tilt: must be a finite number between 0 and"},
    {"nothing_after_the_first_second",
     {"joints", "--csv", "DIR/out", "--time", "1"},
     "--time: must be a finite number between 2 and 1000"},
    {"step_of_a_second",
     {"joints", "--csv", "DIR/out", "--dt", "1"},
     "--dt: must be a finite number between"},
    {"no_threads", {"map", "--csv", "DIR/out", "--threads", "0"}, "--threads: must be a whole number"}};

INSTANTIATE_TEST_SUITE_P(Each, BadOptionsOfWorkPrecision, testing::ValuesIn(kBadOptions),
                         [](const auto& options) { return options.param.what; });

TEST(BadScenarioOfWorkPrecision, IsABodyWithRotors) {
  const TemporaryDirectory directory;
  write_file(directory / "rotor.json", R"({"inertia": [1, 2, 3], "angular_velocity": [1, 2, 3],
                                            "rotor_momentum": [0, 0, 1], "dt": 0.1, "duration": 1})");
  const CommandResult result =
      Command(POLHODE_WORKPRECISION_EXECUTABLE, {"curve", "--scenario", (directory / "rotor.json").string()})
          .wait();
  expect_refused_in_one_line(result);
  EXPECT_THAT(result.standard_error, HasSubstr("not a free body; valid is one without"));
}

}  // namespace
}  // namespace polhode::demos
