#include "scenario/drive_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenario/scenario_reader.h"
#include "scenario/scenario_writer.h"

namespace polhode::demos {
namespace {

using testing::HasSubstr;
using testing::Not;

// Returns a free body with more keys; `more` is `, "key": value ...` or empty.
std::string body_with(const std::string& more) {
  return R"({"inertia": [1, 2, 3], "dt": 0.5, "duration": 10)" + more + "}";
}

std::string body_with_law(const std::string& law) {
  return body_with(", \"torque_law\": " + law);
}

std::string message_of(const std::string& text) {
  try {
    parse_scenario(text, "bad.json");
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "no error";
}

template <class Law>
Law law_in(const std::string& text) {
  return std::get<Law>(parse_scenario(body_with_law(text), "a.json").body.drive.law.value());
}

TEST(DriveKeys, ReadsRotorsAndTheirMotors) {
  const Drive drive = parse_scenario(body_with(R"(, "rotor_momentum": [1, 2, 3], "rotor_torque": [
      {"torque_B": [4, 5, 6]}, {"torque_B": [7, 8, 9], "from": 1, "until": 2}])"),
                                     "a.json")
                          .body.drive;
  EXPECT_EQ(drive.rotor_momentum_B, Vector3(1, 2, 3));
  ASSERT_EQ(drive.motor_torques.size(), 2u);
  EXPECT_EQ(drive.motor_torques[0].torque_B, Vector3(4, 5, 6));
  EXPECT_EQ(drive.motor_torques[0].from_s, 0.0);
  EXPECT_EQ(drive.motor_torques[0].until_s, 1e11) << "to the end";
  EXPECT_EQ(drive.motor_torques[1].from_s, 1.0);
  EXPECT_EQ(drive.motor_torques[1].until_s, 2.0);
  EXPECT_FALSE(drive.law);
}

TEST(DriveKeys, ReadsEveryKindOfLaw) {
  const auto planet =
      law_in<GravityGradient>(R"({"kind": "gravity_gradient", "mu": 5, "centre": [1, 2, 3]})");
  EXPECT_EQ(planet.mu, 5.0);
  EXPECT_EQ(planet.centre_W, Vector3(1, 2, 3));
  EXPECT_TRUE(law_in<GravityGradient>(R"({"kind": "gravity_gradient", "mu": 5})").centre_W.isZero(0.0));
  const auto magnet =
      law_in<MagneticDipole>(R"({"kind": "magnetic_dipole", "dipole_B": [1, 2, 3], "field": [4, 5, 6]})");
  EXPECT_EQ(magnet.dipole_B, Vector3(1, 2, 3));
  EXPECT_EQ(magnet.field_W, Vector3(4, 5, 6));
  const auto spring =
      law_in<OrientationSpring>(R"({"kind": "spring", "orientation": [0, 0, 2, 0], "stiffness": 7})");
  EXPECT_EQ(spring.target_WB.coeffs(), Quaternion(0, 0, 1, 0).coeffs());
  EXPECT_EQ(spring.stiffness, 7.0);
  EXPECT_EQ(law_in<RateDamping>(R"({"kind": "rate_damping", "coefficients_B": [1, 2, 3]})").coefficients_B,
            Vector3(1, 2, 3));
  const auto damper =
      law_in<InternalDamping>(R"({"kind": "internal_damping", "moment": 2, "coefficient": 3})");
  EXPECT_EQ(damper.moment, 2.0);
  EXPECT_EQ(damper.coefficient, 3.0);
}

TEST(DriveKeys, FindsWhatTheWriterWrote) {
  for (const char* law : {R"({"kind": "gravity_gradient", "mu": 5.5, "centre": [1, 2, 3]})",
                          R"({"kind": "magnetic_dipole", "dipole_B": [1, 2, 3], "field": [4, 5, 6]})",
                          R"({"kind": "spring", "orientation": [0.8, 0, 0.6, 0], "stiffness": 7})",
                          R"({"kind": "rate_damping", "coefficients_B": [1, 2, 3]})",
                          R"({"kind": "internal_damping", "moment": 2.5, "coefficient": 3})"}) {
    const nlohmann::json written = scenario_json(parse_scenario(body_with_law(law), "a.json"));
    EXPECT_EQ(written["torque_law"], nlohmann::json::parse(law));
    EXPECT_EQ(nlohmann::json(scenario_json(parse_scenario(written.dump(), "b.json"))), written);
  }
  const std::string keys = R"("rotor_momentum": [1, 0, 3],
      "rotor_torque": [{"torque_B": [4, 5, 6], "from": 1, "until": 2.5}])";
  const nlohmann::json written = scenario_json(parse_scenario(
      body_with(", " + keys + R"(, "others": [{"inertia": [1, 1, 1], )" + keys + "}]"), "a.json"));
  const nlohmann::json given = nlohmann::json::parse("{" + keys + "}");
  for (const nlohmann::json& body : {written, written["others"][0]}) {
    EXPECT_EQ(body["rotor_momentum"], given["rotor_momentum"]);
    EXPECT_EQ(body["rotor_torque"], given["rotor_torque"]);
  }
}

TEST(DriveKeys, LeavesABodyThatNothingDrivesAsItWas) {
  const Scenario scenario = parse_scenario(body_with(""), "a.json");
  EXPECT_FALSE(scenario.has_rotors());
  EXPECT_TRUE(scenario.is_torque_free());
  const std::string written = scenario_json(scenario).dump();
  EXPECT_THAT(written, Not(HasSubstr("rotor")));
  EXPECT_THAT(written, Not(HasSubstr("torque_law")));
}

struct BadDrive {
  std::string keys;
  std::string message;  ///< after "bad.json: "
};

std::ostream& operator<<(std::ostream& stream, const BadDrive& bad) {
  return stream << bad.keys;
}

class BadDriveInFile : public testing::TestWithParam<BadDrive> {};

TEST_P(BadDriveInFile, IsRefusedWithKeyAndWhatIsValid) {
  EXPECT_EQ(message_of(body_with(", " + GetParam().keys)), "bad.json: " + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadDriveInFile,
    testing::Values(
        BadDrive{R"("rotor_momentum": 3)",
                 "\"rotor_momentum\": must be a list of 3 numbers, each a finite number between -1e+09 and "
                 "1e+09, is 3"},
        BadDrive{R"("rotor_torque": [1, 2, 3])", "\"rotor_torque[0]\": must be an object {...}, is 1"},
        BadDrive{R"("rotor_torque": [{"from": 1}])",
                 "\"rotor_torque[0].torque_B\": the key is missing; it must be a list of 3 numbers, each a "
                 "finite number between -1e+09 and 1e+09"},
        BadDrive{R"("rotor_torque": [{"torque_B": [1, 2, 3], "from": 5, "until": 4}])",
                 "\"rotor_torque[0].until\": must be at least \"from\", 5, is 4"},
        BadDrive{R"("rotor_torque": [{"torque_B": [1, 2, 3], "from": -1}])",
                 "\"rotor_torque[0].from\": must be a finite number between 0 and 1e+11, is -1"},
        BadDrive{R"("rotor_torque": [{"torque_B": [1, 2, 3], "at": 4}])",
                 "\"rotor_torque[0].at\": unknown key; valid are from, torque_B, until"},
        BadDrive{R"("torque_law": {"mu": 1})", "\"torque_law.kind\": the key is missing; it must be a text"},
        BadDrive{R"("torque_law": {"kind": "wind"})",
                 "\"torque_law.kind\": unknown torque law \"wind\"; valid are gravity_gradient, "
                 "magnetic_dipole, spring, rate_damping, internal_damping"},
        BadDrive{R"("torque_law": {"kind": "gravity_gradient", "mu": 0})",
                 "\"torque_law.mu\": must be a finite number between 1e-09 and 1e+15, is 0"},
        BadDrive{R"("torque_law": {"kind": "gravity_gradient", "mu": 1, "moment": 1})",
                 "\"torque_law.moment\": unknown key; valid are centre, kind, mu"},
        BadDrive{R"("torque_law": {"kind": "spring", "stiffness": -1})",
                 "\"torque_law.stiffness\": must be a finite number between 0 and 1e+09, is -1"},
        BadDrive{R"("torque_law": {"kind": "rate_damping", "coefficients_B": [1, -2, 3]})",
                 "\"torque_law.coefficients_B[1]\": must be a finite number between 0 and 1e+09, is -2"},
        BadDrive{R"("torque_law": {"kind": "internal_damping", "moment": 0, "coefficient": 1})",
                 "\"torque_law.moment\": must be a finite number between 1e-12 and 1e+09, is 0"}));

}  // namespace
}  // namespace polhode::demos
