#include "scenario/scenario_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "demos/foreign_locale.h"
#include "demos/support_files.h"
#include "scenario/scenario_writer.h"

namespace polhode::demos {
namespace {

using testing::ElementsAre;

// Returns a free body with more keys; `more` is `, "key": value ...` or empty.
std::string body_with(const std::string& more) {
  return R"({"inertia": [1, 2, 3], "dt": 0.5, "duration": 10)" + more + "}";
}

std::string message_of(const std::string& text) {
  try {
    parse_scenario(text, "bad.json");
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ScenarioReader, RunsAFreeBodyOnFiveKeysAlone) {
  const Scenario scenario = parse_scenario(
      R"({"inertia":[1,2,3],"orientation":[0,0,0,2],"angular_velocity":[4,5,6],"dt":0.5,"duration":10})",
      "dir/mine.json");
  EXPECT_EQ(scenario.name, "mine");
  EXPECT_EQ(scenario.body.inertia_B, Vector3(1, 2, 3));
  EXPECT_THAT(scenario.body.q_WB.coeffs(), ElementsAre(0, 0, 1, 0)) << "x, y, z, w, of unit length";
  EXPECT_EQ(scenario.body.omega_W, Vector3(4, 5, 6));
  EXPECT_EQ(scenario.body.mass, 1.0);
  EXPECT_EQ(scenario.gravity_W, Vector3(0, 0, 0));
  EXPECT_EQ(scenario.dt, 0.5);
  EXPECT_EQ(scenario.duration, 10.0);
  EXPECT_FALSE(scenario.ground || scenario.constraint);
}

TEST(ScenarioReader, TakesAnInertiaThatBreaksTheTriangleInequality) {
  EXPECT_EQ(message_of(R"({"inertia": [24.1449, 28.436, 118.812], "dt": 0.5, "duration": 10})"), "no error");
}

TEST(ScenarioReader, ReadsEveryKey) {
  const Scenario scenario = parse_scenario(
      R"({"name": "n", "description": "d", "mass": 3,
          "shape": {"type": "compound", "parts": [{"half_extents": [1, 2, 3], "mass": 1},
                                                  {"half_extents": [4, 5, 6], "at": [7, 8, 9], "mass": 2}]},
          "position": [1, 2, 3], "linear_velocity": [4, 5, 6], "impulses": [{"impulse": [1, 0, 0], "at": [0, 1, 0]}],
          "friction": 0.25, "restitution": 0.75, "damping": {"linear": 0.125, "angular": 0.375},
          "gravity": [0, 0, -10], "torque": [1, 1, 2], "constraint": {"type": "point_to_point", "pivot_B": [0, 0, 1]},
          "ground": {"height": -1, "normal": [0, 0, 5], "friction": 2, "restitution": 0.5},
          "others": [{"inertia": [7, 8, 9], "shape": {"type": "sphere", "radius": 2}},
                     {"shape": {"type": "box", "half_extents": [1, 1, 2]}, "mass": 5}],
          "solver_iterations": 20, "dt": 0.25, "duration": 1})",
      "all.json");
  EXPECT_EQ(scenario.name, "n");
  EXPECT_EQ(scenario.description, "d");
  EXPECT_FALSE(scenario.body.inertia_B);
  EXPECT_EQ(scenario.body.mass, 3.0);
  const auto& parts = std::get<Compound>(scenario.body.shape).parts;
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].at, Vector3(0, 0, 0));
  EXPECT_EQ(parts[1].half_extents, Vector3(4, 5, 6));
  EXPECT_EQ(parts[1].at, Vector3(7, 8, 9));
  EXPECT_EQ(parts[1].mass, 2.0);
  EXPECT_EQ(scenario.body.position_W, Vector3(1, 2, 3));
  EXPECT_EQ(scenario.body.velocity_W, Vector3(4, 5, 6));
  ASSERT_EQ(scenario.body.impulses.size(), 1u);
  EXPECT_EQ(scenario.body.impulses[0].impulse_W, Vector3(1, 0, 0));
  EXPECT_EQ(scenario.body.impulses[0].at_W, Vector3(0, 1, 0));
  EXPECT_EQ(scenario.body.friction, 0.25);
  EXPECT_EQ(scenario.body.restitution, 0.75);
  EXPECT_EQ(scenario.body.damping.linear, 0.125);
  EXPECT_EQ(scenario.body.damping.angular, 0.375);
  EXPECT_EQ(scenario.gravity_W, Vector3(0, 0, -10));
  EXPECT_EQ(scenario.torque_W, Vector3(1, 1, 2));
  EXPECT_EQ(scenario.constraint->pivot_B, Vector3(0, 0, 1));
  EXPECT_EQ(scenario.ground->height, -1.0);
  EXPECT_EQ(scenario.ground->normal_W, Vector3(0, 0, 1));
  EXPECT_EQ(scenario.ground->friction, 2.0);
  EXPECT_EQ(scenario.ground->restitution, 0.5);
  ASSERT_EQ(scenario.others.size(), 2u);
  EXPECT_EQ(scenario.others[0].inertia_B, Vector3(7, 8, 9));
  EXPECT_EQ(std::get<Sphere>(scenario.others[0].shape).radius, 2.0);
  EXPECT_EQ(std::get<Box>(scenario.others[1].shape).half_extents, Vector3(1, 1, 2));
  EXPECT_EQ(scenario.others[1].mass, 5.0);
  EXPECT_EQ(scenario.solver_iterations, 20);
}

TEST(ScenarioReader, FindsWhatTheWriterWrote) {
  const nlohmann::json given = nlohmann::json::parse(
      R"({"name": "n", "description": "d", "inertia": [1, 2, 3], "mass": 3,
          "shape": {"type": "compound", "parts": [{"half_extents": [1, 2, 3], "at": [7, 8, 9], "mass": 3}]},
          "position": [1, 2, 3], "orientation": [0, 1, 0, 0], "angular_velocity": [9, 8, 7], "linear_velocity": [4, 5, 6],
          "impulses": [{"impulse": [1, 0, 0], "at": [0, 1, 0]}],
          "friction": 0.25, "restitution": 0.75, "damping": {"linear": 0.125, "angular": 0.375},
          "gravity": [0, 0, -10], "torque": [1, 1, 2], "constraint": {"type": "point_to_point", "pivot_B": [0, 0, 1]},
          "ground": {"height": -1, "normal": [0, 1, 0], "friction": 2, "restitution": 0.5},
          "others": [], "solver_iterations": 20, "dt": 0.25, "duration": 1})");
  const std::string written = scenario_json(parse_scenario(given.dump(), "given.json")).dump();
  EXPECT_EQ(nlohmann::json::parse(written), given) << "with every key given, each comes back";

  const std::string defaults =
      scenario_json(parse_scenario(body_with(R"(, "others": [{"inertia": [7, 8, 9]}])"), "a.json")).dump();
  EXPECT_EQ(scenario_json(parse_scenario(defaults, "b.json")).dump(), defaults);
}

// Normalizing the resulting unit quaternion again would change its last bit.
TEST(ScenarioReader, FindsTheSameOrientationAgain) {
  const std::string written =
      scenario_json(
          parse_scenario(body_with(R"(, "orientation": [0.96891242171064473, 0, 0.24740791850904588, 0],
          "ground": {"normal": [1, 2, 3]})"),
                         "a.json"))
          .dump();
  EXPECT_EQ(scenario_json(parse_scenario(written, "b.json")).dump(), written);
  for (int i = 1; i < 1000; ++i) {
    const std::string number = std::to_string(i);
    std::string keys = R"(, "orientation": [3, )" + number;
    keys += R"(, 2, 7], "ground": {"normal": [5, )" + number;
    keys += ", 1]}";
    const std::string once = scenario_json(parse_scenario(body_with(keys), "a.json")).dump();
    EXPECT_EQ(scenario_json(parse_scenario(once, "b.json")).dump(), once) << i;
  }
}

TEST(ScenarioReader, IgnoresTheGlobalLocale) {
  const ForeignLocale foreign;
  const Scenario scenario = parse_scenario(body_with(R"(, "mass": 1234.5)"), "a.json");
  EXPECT_EQ(scenario.body.mass, 1234.5);
  EXPECT_THAT(scenario_json(scenario).dump(), testing::HasSubstr(R"("mass":1234.5)"));
  EXPECT_EQ(message_of(body_with(R"(, "mass": 1234567890.5)")),
            "bad.json: \"mass\": must be a finite number between 1e-09 and 1e+09, is 1234567890.5");
}

struct BadText {
  std::string text;
  std::string message;  ///< after "bad.json: "
};

std::ostream& operator<<(std::ostream& stream, const BadText& bad) {
  return stream << bad.text;
}

class BadScenario : public testing::TestWithParam<BadText> {};

TEST_P(BadScenario, IsRefusedWithFileAndKeyAndWhatIsValid) {
  EXPECT_EQ(message_of(GetParam().text), "bad.json: " + GetParam().message);
}

const std::string kVectorRange = "a list of 3 numbers, each a finite number between ";
const std::string kTopKeys =
    "angular_velocity, constraint, damping, description, dt, duration, friction, gravity, ground, impulses, "
    "inertia, linear_velocity, mass, name, orientation, others, position, restitution, rotor_momentum, "
    "rotor_torque, shape, solver_iterations, torque, torque_law";

INSTANTIATE_TEST_SUITE_P(
    Missing, BadScenario,
    testing::Values(
        BadText{R"({"dt": 1, "duration": 2})",
                "\"inertia\": the key is missing; it must be " + kVectorRange + "1e-12 and 1e+09"},
        BadText{R"({"inertia": [1, 2, 3], "duration": 2})",
                "\"dt\": the key is missing; it must be a finite number between 1e-06 and 1000"},
        BadText{R"({"inertia": [1, 2, 3], "dt": 1})",
                "\"duration\": the key is missing; it must be a finite number between 1e-06 and 1e+11"},
        BadText{body_with(R"(, "shape": {"type": "sphere"})"),
                "\"shape.radius\": the key is missing; it must be a finite number between 1e-06 and 1e+06"},
        BadText{
            body_with(R"(, "impulses": [{"at": [1, 2, 3]}])"),
            "\"impulses[0].impulse\": the key is missing; it must be " + kVectorRange + "-1e+09 and 1e+09"}));

INSTANTIATE_TEST_SUITE_P(
    Unknown, BadScenario,
    testing::Values(
        BadText{body_with(R"(, "spin": 1)"), "\"spin\": unknown key; valid are " + kTopKeys},
        BadText{body_with(R"(, "shape": {"type": "sphere", "radius": 1, "colour": 2})"),
                "\"shape.colour\": unknown key; valid are radius, type"},
        BadText{
            body_with(
                R"(, "shape": {"type": "compound", "parts": [{"half_extents": [1, 1, 1], "mass": 1, "a": 1}]})"),
            "\"shape.parts[0].a\": unknown key; valid are at, half_extents, mass"},
        BadText{body_with(R"(, "ground": {"slope": 1})"),
                "\"ground.slope\": unknown key; valid are friction, height, normal, restitution"},
        BadText{body_with(R"(, "damping": {"x": 1})"),
                "\"damping.x\": unknown key; valid are angular, linear"},
        BadText{body_with(R"(, "impulses": [{"impulse": [1, 2, 3], "x": 1}])"),
                "\"impulses[0].x\": unknown key; valid are at, impulse"},
        BadText{body_with(R"(, "constraint": {"type": "point_to_point", "pivot_B": [1, 2, 3], "x": 1})"),
                "\"constraint.x\": unknown key; valid are pivot_B, type"},
        BadText{body_with(R"(, "others": [{"inertia": [1, 2, 3], "dt": 1}])"),
                "\"others[0].dt\": unknown key; valid are angular_velocity, damping, friction, impulses, "
                "inertia, linear_velocity, mass, orientation, position, restitution, rotor_momentum, "
                "rotor_torque, shape, torque_law"},
        BadText{body_with(R"(, "shape": {"type": "cone"})"),
                "\"shape.type\": unknown shape \"cone\"; valid are sphere, box, compound"},
        BadText{body_with(R"(, "constraint": {"type": "hinge"})"),
                "\"constraint.type\": unknown constraint \"hinge\"; valid is point_to_point"}));

INSTANTIATE_TEST_SUITE_P(
    WrongType, BadScenario,
    testing::Values(
        BadText{"[1, 2]", "the file: must be an object {...}, is [1,2]"},
        BadText{body_with(R"(, "name": 7)"), "\"name\": must be a text, is 7"},
        BadText{body_with(R"(, "mass": "heavy")"),
                "\"mass\": must be a finite number between 1e-09 and 1e+09, is \"heavy\""},
        BadText{body_with(R"(, "mass": null)"),
                "\"mass\": must be a finite number between 1e-09 and 1e+09, is null"},
        BadText{body_with(R"(, "mass": "NaN")"),
                "\"mass\": must be a finite number between 1e-09 and 1e+09, is \"NaN\""},
        BadText{body_with(R"(, "gravity": -9.81)"),
                "\"gravity\": must be " + kVectorRange + "-1e+09 and 1e+09, is -9.81"},
        BadText{body_with(R"(, "gravity": [0, -9.81])"),
                "\"gravity\": must be " + kVectorRange + "-1e+09 and 1e+09, is [0,-9.81]"},
        BadText{body_with(R"(, "gravity": [0, 0, "g"])"),
                "\"gravity[2]\": must be a finite number between -1e+09 and 1e+09, is \"g\""},
        BadText{body_with(R"(, "orientation": [1, 0, 0])"),
                "\"orientation\": must be a list of 4 numbers w, x, y, z, each a finite number between "
                "-1e+06 and 1e+06, is [1,0,0]"},
        BadText{body_with(R"(, "shape": "box")"), "\"shape\": must be an object {...}, is \"box\""},
        BadText{body_with(R"(, "others": {})"), "\"others\": must be a list of objects [{...}, ...], is {}"},
        BadText{body_with(R"(, "others": [1])"), "\"others[0]\": must be an object {...}, is 1"},
        BadText{body_with(R"(, "solver_iterations": 1.5)"),
                "\"solver_iterations\": must be a whole number, is 1.5"}));

INSTANTIATE_TEST_SUITE_P(
    OutOfRange, BadScenario,
    testing::Values(
        BadText{R"({"inertia": [1, 0, 3], "dt": 1, "duration": 2})",
                "\"inertia[1]\": must be a finite number between 1e-12 and 1e+09, is 0"},
        BadText{R"({"inertia": [1, 2, 3], "dt": 0, "duration": 2})",
                "\"dt\": must be a finite number between 1e-06 and 1000, is 0"},
        BadText{R"({"inertia": [1, 2, 3], "dt": 1, "duration": -2})",
                "\"duration\": must be a finite number between 1e-06 and 1e+11, is -2"},
        BadText{R"({"inertia": [1, 2, 3], "dt": 1, "duration": 0.5})",
                "\"duration\": duration / dt must be between 1 and 1e+08 steps, is 0.5 s / 1 s = 0.5"},
        BadText{R"({"inertia": [1, 2, 3], "dt": 1, "duration": 200000000})",
                "\"duration\": duration / dt must be between 1 and 1e+08 steps, is 2e+08 s / 1 s = 2e+08"},
        BadText{body_with(R"(, "orientation": [0, 0, 0, 0])"),
                "\"orientation\": must not be the zero quaternion; [1, 0, 0, 0] is no rotation"},
        BadText{body_with(R"(, "ground": {"normal": [0, 0, 0]})"),
                "\"ground.normal\": must have a direction, is [0,0,0]"},
        BadText{body_with(R"(, "damping": {"linear": 2})"),
                "\"damping.linear\": must be a finite number between 0 and 1, is 2"},
        BadText{body_with(R"(, "friction": -1)"),
                "\"friction\": must be a finite number between 0 and 1000, is -1"},
        BadText{body_with(R"(, "solver_iterations": 0)"),
                "\"solver_iterations\": must be a finite number between 1 and 1000, is 0"},
        BadText{body_with(R"(, "shape": {"type": "compound", "parts": []})"),
                "\"shape.parts\": must be a list of at least one box {...}"},
        BadText{
            body_with(
                R"(, "mass": 3, "shape": {"type": "compound", "parts": [{"half_extents": [1, 1, 1], "mass": 2}]})"),
            "\"mass\": must be the sum of the parts' masses, 2, or left out"}));

INSTANTIATE_TEST_SUITE_P(
    NoJson, BadScenario,
    testing::Values(
        BadText{
            "",
            "parse error at line 1, column 1: syntax error while parsing value - unexpected end of input; "
            "expected '[', '{', or a literal; valid is a JSON object"},
        BadText{R"({"mass": NaN})",
                "parse error at line 1, column 10: syntax error while parsing value - invalid literal; last "
                "read: '\"mass\": N'; valid is a JSON object"},
        BadText{body_with(R"(, "mass": 1e999)"),
                "\"mass\": number overflow parsing '1e999'; valid is a finite number"},
        BadText{body_with(", \"name\": \"a\xff\""),
                "parse error at line 1, column 61: syntax error while parsing value - invalid string: "
                "ill-formed UTF-8 byte; last read: '\"a\xff'; valid is a JSON object"},
        BadText{body_with("") + std::string("\0, 1", 4), "byte 50 is a zero byte; valid is a JSON object"},
        BadText{std::string(17, '['),
                "lists and objects are nested deeper than 16 levels; valid are at most 16"},
        BadText{body_with(", \"mass\": " + std::string(400000, '[') + std::string(400000, ']')),
                "lists and objects are nested deeper than 16 levels; valid are at most 16"},
        BadText{body_with(R"(, "mass": 1, "mass": 2)"), "\"mass\": the key is given twice; valid is once"},
        BadText{body_with(R"(, "damping": {"linear": 0, "linear": 0})"),
                "\"linear\": the key is given twice; valid is once"}));

const std::string kOneLine = "must be one line without control characters or directional formatting, has \"";

INSTANTIATE_TEST_SUITE_P(
    UnprintableText, BadScenario,
    testing::Values(BadText{body_with(R"(, "name": "a\u001b[2J")"),
                            "\"name\": " + kOneLine + "\\x1b\" in it"},
                    BadText{body_with(R"(, "name": "\u0000")"), "\"name\": " + kOneLine + "\\x00\" in it"},
                    BadText{body_with(R"(, "description": "two\nlines")"),
                            "\"description\": " + kOneLine + "\\x0a\" in it"},
                    BadText{body_with(R"(, "description": "\u009b2J")"),
                            "\"description\": " + kOneLine + "\\xc2\\x9b\" in it"},
                    BadText{body_with(R"(, "description": "\u202etop")"),
                            "\"description\": " + kOneLine + "\\xe2\\x80\\xae\" in it"},
                    BadText{body_with(", \"description\": \"" + std::string(1025, 'd') + "\""),
                            "\"description\": must be a text of at most 1024 bytes, has 1025"},
                    BadText{body_with(", \"" + std::string(1000, 'k') + "\": 1"),
                            "\"" + std::string(50, 'k') + " ... " + std::string(50, 'k') +
                                "\": unknown key; valid are " + kTopKeys}));

TEST(ScenarioReader, TakesTextsOfAnyScriptUpToTheirLimit) {
  const std::string text = "Trägheit \u65e5\u672c \u05e9 </script> =1+1, \\\"" + std::string(980, 'd');
  const Scenario scenario =
      parse_scenario(body_with(", \"name\": \"" + text + "\", \"description\": \"" + text + "\""), "a.json");
  EXPECT_EQ(scenario.name, scenario.description);
  EXPECT_THAT(scenario.name, testing::StartsWith("Trägheit \u65e5\u672c \u05e9 </script> =1+1, \"ddd"));
}

TEST(ScenarioReader, NamesAScenarioLikeItsFileWithWhatIsNotPrintableEscaped) {
  EXPECT_EQ(parse_scenario(body_with(""), "dir/a\x1b\xff.json").name, "a\\x1b\\xff");
}

TEST(ScenarioReader, NamesAFileThatIsNotThere) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "none.json").string();
  EXPECT_THAT([&] { read_scenario(file); },
              testing::ThrowsMessage<ScenarioError>(testing::StartsWith(file + ": no such file")));
}

TEST(ScenarioReader, SaysWhatAFileMayBe) {
  const TemporaryDirectory directory;
  const std::string valid =
      "; a scenario is a JSON file of at most 1048576 bytes; --list shows those available";
  EXPECT_THAT([&] { read_scenario(directory.path()); },
              testing::ThrowsMessage<ScenarioError>(directory.path().string() +
                                                    ": neither a regular file nor a pipe" + valid));
  write_file(directory / "large.json", std::string((1 << 20) + 1, ' '));
  EXPECT_THAT(
      [&] { read_scenario(directory / "large.json"); },
      testing::ThrowsMessage<ScenarioError>(testing::HasSubstr(": has more than 1048576 bytes" + valid)));
  write_file(directory / "full.json", body_with("") + std::string((1 << 20) - body_with("").size(), ' '));
  EXPECT_EQ(read_scenario(directory / "full.json").name, "full");
}

TEST(ScenarioReader, PassesOverAByteOrderMark) {
  EXPECT_EQ(parse_scenario("\xef\xbb\xbf" + body_with(""), "a.json").dt, 0.5);
}

std::string repeated(const std::string& text, int count) {
  std::string list;
  for (int i = 0; i < count; ++i) list += (i == 0 ? "" : ", ") + text;
  return list;
}

std::string boxes(int count) {
  return R"({"type": "compound", "parts": [)" + repeated(R"({"half_extents": [1, 1, 1], "mass": 1})", count) +
         "]}";
}

std::string others(const std::string& shape, int count) {
  return R"(, "others": [)" + repeated("{\"shape\": " + shape + "}", count) + "]";
}

TEST(ScenarioReader, TakesTwoHundredShapesInAll) {
  const std::string sphere = R"({"type": "sphere", "radius": 1})";
  EXPECT_EQ(message_of(body_with(others(sphere, 199))), "no error");
  const std::string valid = " shapes in total, counting each part of a compound; valid is at most 200";
  EXPECT_EQ(message_of(body_with(others(sphere, 200))), "bad.json: \"others\": makes it 201" + valid);
  EXPECT_EQ(message_of(body_with(others(boxes(50), 4))), "bad.json: \"others\": makes it 201" + valid);
  EXPECT_EQ(message_of(body_with(", \"shape\": " + boxes(201))), "bad.json: \"shape\": makes it 201" + valid);
}

}  // namespace
}  // namespace polhode::demos
