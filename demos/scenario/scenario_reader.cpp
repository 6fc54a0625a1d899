#include "scenario/scenario_reader.h"

#include <cmath>

#include "scenario/input_file.h"
#include "scenario/key_reader.h"
#include "scenario/number_text.h"
#include "scenario/printable_text.h"
#include "scenario/scenario_keys.h"

namespace polhode::demos {

namespace {

// A scenario has some dozen lines; the limit catches a file given by mistake.
constexpr std::size_t kLargestFile = 1 << 20;

}  // namespace

void check(CheckedObject& object, const Compound& compound) {
  if (compound.parts.empty()) object.fail("parts", "must be a list of at least one box {...}");
}

void check(CheckedObject& object, const MotorTorque& torque) {
  if (torque.until_s >= torque.from_s) return;
  object.fail("until", "must be at least \"from\", " + number_text(torque.from_s) + ", is " +
                           number_text(torque.until_s));
}

// The mass of a compound is the sum of its parts' masses; if it is given too, it must agree.
void check(CheckedObject& object, Body& body) {
  const auto* compound = std::get_if<Compound>(&body.shape);
  if (compound == nullptr) return;
  double sum = 0.0;
  for (const BoxPart& part : compound->parts) sum += part.mass;
  if (!object.has("mass")) body.mass = sum;
  if (std::abs(body.mass - sum) > 1e-9 * sum) {
    object.fail("mass", "must be the sum of the parts' masses, " + number_text(sum) + ", or left out");
  }
}

namespace {

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
                  " shapes in total, counting each part of a compound; valid is at most " +
                  std::to_string(kMostShapes));
}

void check_step_count(const CheckedObject& object, const Scenario& scenario) {
  try {
    step_count(scenario.dt, scenario.duration);
  } catch (const std::invalid_argument& error) {
    object.fail("duration", error.what());
  }
}

}  // namespace

void check(CheckedObject& object, Scenario& scenario) {
  check(object, scenario.body);
  check_shape_count(object, scenario);
  check_step_count(object, scenario);
}

Scenario parse_scenario(const std::string& text, const std::string& file_name) {
  const nlohmann::json json = parse_json(text, file_name);
  Scenario scenario;
  scenario.name = printable(std::filesystem::path(file_name).stem().string());
  read_keys(CheckedObject(json, file_name), scenario);
  return scenario;
}

Scenario read_scenario(const std::filesystem::path& file) {
  try {
    return parse_scenario(read_text_file(file, kLargestFile), file.string());
  } catch (const InputFileError& error) {
    throw ScenarioError(file.string() + ": " + error.what() + "; a scenario is a JSON file of at most " +
                        std::to_string(kLargestFile) + " bytes; --list shows those available");
  }
}

}  // namespace polhode::demos
