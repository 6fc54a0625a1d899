#include "scenario/drive_reader.h"

#include "scenario/number_text.h"
#include "scenario/scenario.h"

namespace polhode::demos {

namespace {

constexpr Range kCoefficient{0.0, 1e9};
constexpr Range kGravitationalParameter{1e-9, 1e15};  // the Earth's is 4e14
constexpr Range kTime{0.0, 1e11};

ChosenLaw read_law_of(const std::string& kind, CheckedObject& law) {
  const Vector3 zero = Vector3::Zero();
  if (kind == "gravity_gradient") {
    return GravityGradient{law.number("mu", kGravitationalParameter), law.vector("centre", kPlace, zero)};
  }
  if (kind == "magnetic_dipole") {
    return MagneticDipole{law.vector("dipole_B", kAnySign), law.vector("field", kAnySign)};
  }
  if (kind == "spring") {
    return OrientationSpring{law.orientation("orientation"), law.number("stiffness", kCoefficient)};
  }
  if (kind == "rate_damping") return RateDamping{law.vector("coefficients_B", kCoefficient)};
  if (kind == "internal_damping") {
    return InternalDamping{law.number("moment", kInertiaRange), law.number("coefficient", kCoefficient)};
  }
  law.fail("kind", "unknown torque law \"" + kind +
                       "\"; valid are gravity_gradient, magnetic_dipole, spring, rate_damping, "
                       "internal_damping");
}

ChosenLaw read_law(CheckedObject law) {
  const std::string kind = law.text("kind");
  ChosenLaw result = read_law_of(kind, law);
  law.refuse_unknown_keys();
  return result;
}

MotorTorque read_motor_torque(CheckedObject object) {
  const MotorTorque torque{object.vector("torque_B", kAnySign), object.number("from", kTime, 0.0),
                           object.number("until", kTime, kTime.highest)};
  if (torque.until_s < torque.from_s) {
    object.fail("until", "must be at least \"from\", " + number_text(torque.from_s) + ", is " +
                             number_text(torque.until_s));
  }
  object.refuse_unknown_keys();
  return torque;
}

}  // namespace

Drive read_drive(CheckedObject& body) {
  Drive drive;
  drive.rotor_momentum_B = body.vector("rotor_momentum", kAnySign, drive.rotor_momentum_B);
  for (const CheckedObject& torque : body.objects("rotor_torque")) {
    drive.motor_torques.push_back(read_motor_torque(torque));
  }
  if (body.has("torque_law")) drive.law = read_law(body.object("torque_law"));
  return drive;
}

}  // namespace polhode::demos
