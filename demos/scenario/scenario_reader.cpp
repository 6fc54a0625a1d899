#include "scenario/scenario_reader.h"

#include <cmath>

#include "polhode/rotation_limits.h"
#include "scenario/checked_object.h"
#include "scenario/drive_reader.h"
#include "scenario/input_file.h"
#include "scenario/number_text.h"
#include "scenario/printable_text.h"

namespace polhode::demos {

namespace {

constexpr Range kMass{1e-9, 1e9};
constexpr Range kLength{1e-6, 1e6};
constexpr Range kFraction{0.0, 1.0};
constexpr Range kFriction{0.0, 1e3};
constexpr Range kAngularSpeed{-kMaximumAngularSpeed, kMaximumAngularSpeed};

// A scenario has some dozen lines; this is for a file given by mistake.
constexpr std::size_t kLargestFile = 1 << 20;

BoxPart read_part(CheckedObject part) {
  const BoxPart result{part.vector("half_extents", kLength),
                       part.vector("at", kPlace, Vector3(Vector3::Zero())), part.number("mass", kMass)};
  part.refuse_unknown_keys();
  return result;
}

Compound read_compound(CheckedObject& shape) {
  Compound compound;
  for (const CheckedObject& part : shape.objects("parts")) compound.parts.push_back(read_part(part));
  if (compound.parts.empty()) shape.fail("parts", "must be a list of at least one box {...}");
  return compound;
}

Shape read_shape(CheckedObject shape) {
  const std::string type = shape.text("type");
  Shape result;
  if (type == "sphere") {
    result = Sphere{shape.number("radius", kLength)};
  } else if (type == "box") {
    result = Box{shape.vector("half_extents", kLength)};
  } else if (type == "compound") {
    result = read_compound(shape);
  } else {
    shape.fail("type", "unknown shape \"" + type + "\"; valid are sphere, box, compound");
  }
  shape.refuse_unknown_keys();
  return result;
}

// The mass of a compound is the sum of its parts'; given as well, it must agree.
double read_mass(CheckedObject& object, const Shape& shape) {
  const auto* compound = std::get_if<Compound>(&shape);
  if (compound == nullptr) return object.number("mass", kMass, 1.0);
  double sum = 0.0;
  for (const BoxPart& part : compound->parts) sum += part.mass;
  const double mass = object.number("mass", kMass, sum);
  if (std::abs(mass - sum) > 1e-9 * sum) {
    object.fail("mass", "must be the sum of the parts' masses, " + number_text(sum) + ", or left out");
  }
  return mass;
}

Impulse read_impulse(CheckedObject object) {
  const Impulse impulse{object.vector("impulse", kAnySign),
                        object.vector("at", kPlace, Vector3(Vector3::Zero()))};
  object.refuse_unknown_keys();
  return impulse;
}

void read_damping(CheckedObject damping, Body& body) {
  body.linear_damping = damping.number("linear", kFraction, 0.0);
  body.angular_damping = damping.number("angular", kFraction, 0.0);
  damping.refuse_unknown_keys();
}

Body read_body(CheckedObject& object) {
  const Vector3 zero = Vector3::Zero();
  Body body;
  const bool has_shape = object.has("shape");
  body.shape = has_shape ? read_shape(object.object("shape")) : Shape(Sphere{0.5});
  if (object.has("inertia") || !has_shape) body.inertia_B = object.vector("inertia", kInertiaRange);
  body.mass = read_mass(object, body.shape);
  body.position_W = object.vector("position", kPlace, zero);
  body.q_WB = object.orientation("orientation");
  body.omega_W = object.vector("angular_velocity", kAngularSpeed, zero);
  body.velocity_W = object.vector("linear_velocity", kAnySign, zero);
  for (const CheckedObject& impulse : object.objects("impulses"))
    body.impulses.push_back(read_impulse(impulse));
  body.friction = object.number("friction", kFriction, body.friction);
  body.restitution = object.number("restitution", kFraction, body.restitution);
  if (object.has("damping")) read_damping(object.object("damping"), body);
  body.drive = read_drive(object);
  return body;
}

Ground read_ground(CheckedObject object) {
  const Ground ground{object.number("height", kPlace, 0.0), object.direction("normal", Vector3::UnitZ()),
                      object.number("friction", kFriction, 0.5),
                      object.number("restitution", kFraction, 0.0)};
  object.refuse_unknown_keys();
  return ground;
}

PointToPoint read_constraint(CheckedObject object) {
  const std::string type = object.text("type");
  if (type != "point_to_point") {
    object.fail("type", "unknown constraint \"" + type + "\"; valid is point_to_point");
  }
  const PointToPoint constraint{object.vector("pivot_B", kPlace)};
  object.refuse_unknown_keys();
  return constraint;
}

Body read_other(CheckedObject object) {
  const Body body = read_body(object);
  object.refuse_unknown_keys();
  return body;
}

std::size_t shape_count(const Body& body) {
  const auto* compound = std::get_if<Compound>(&body.shape);
  return compound == nullptr ? 1 : compound->parts.size();
}

void check_shape_count(const CheckedObject& object, const Scenario& scenario) {
  std::size_t count = shape_count(scenario.body);
  for (const Body& other : scenario.others) count += shape_count(other);
  if (count <= kMostShapes) return;
  object.fail(scenario.others.empty() ? "shape" : "others",
              "makes it " + std::to_string(count) +
                  " shapes in all, each part of a compound counted; valid is at most " +
                  std::to_string(kMostShapes));
}

void read_times(CheckedObject& object, Scenario& scenario) {
  scenario.dt = object.number("dt", kDtRange);
  scenario.duration = object.number("duration", kDurationRange);
  try {
    step_count(scenario.dt, scenario.duration);
  } catch (const std::invalid_argument& error) {
    object.fail("duration", error.what());
  }
}

}  // namespace

Scenario parse_scenario(const std::string& text, const std::string& file_name) {
  const nlohmann::json json = parse_json(text, file_name);
  CheckedObject object(json, file_name);
  const Vector3 zero = Vector3::Zero();
  Scenario scenario;
  scenario.name = object.text("name", printable(std::filesystem::path(file_name).stem().string()));
  scenario.description = object.text("description", "");
  scenario.body = read_body(object);
  for (const CheckedObject& other : object.objects("others")) scenario.others.push_back(read_other(other));
  check_shape_count(object, scenario);
  scenario.gravity_W = object.vector("gravity", kAnySign, zero);
  scenario.torque_W = object.vector("torque", kAnySign, zero);
  if (object.has("constraint")) scenario.constraint = read_constraint(object.object("constraint"));
  if (object.has("ground")) scenario.ground = read_ground(object.object("ground"));
  scenario.solver_iterations =
      object.whole_number("solver_iterations", {1, 1000}, scenario.solver_iterations);
  read_times(object, scenario);
  object.refuse_unknown_keys();
  return scenario;
}

Scenario read_scenario(const std::filesystem::path& file) {
  try {
    return parse_scenario(read_text_file(file, kLargestFile), file.string());
  } catch (const InputFileError& error) {
    throw ScenarioError(file.string() + ": " + error.what() + "; a scenario is a JSON file of at most " +
                        std::to_string(kLargestFile) + " bytes, see --list for those at hand");
  }
}

}  // namespace polhode::demos
