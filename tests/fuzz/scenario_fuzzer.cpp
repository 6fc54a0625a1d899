// Reads scenario files. Rejected files must throw ScenarioError. An accepted scenario must be the same after
// writing and reading it, and a few steps of it are run.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "record/contender.h"
#include "scenario/scenario_reader.h"
#include "scenario/scenario_writer.h"
#include "scenario/start_motion.h"
#include "world/scenario_world.h"

namespace polhode::demos {
namespace {

constexpr int kSteps = 3;

void check_round_trip(const Scenario& scenario) {
  const std::string written = scenario_json(scenario).dump();
  const std::string written_again = scenario_json(parse_scenario(written, "written")).dump();
  if (written == written_again) return;
  std::fprintf(stderr, "scenario fuzzer: the scenario\n%s\nreads back as\n%s\n", written.c_str(),
               written_again.c_str());
  std::abort();
}

void run_steps(const Scenario& scenario) {
  for (const Contender& contender : find_contenders({"exact", "bullet:implicit_body"})) {
    ScenarioWorld world(scenario, contender);
    for (int i = 0; i < kSteps; ++i) world.step();
    world.sample();
  }
}

void read(const std::string& text) {
  Scenario scenario;
  try {
    scenario = parse_scenario(text, "input");
  } catch (const ScenarioError&) {
    return;
  }
  try {
    scenario = resolved(scenario);
  } catch (const std::invalid_argument&) {
    return;
  }
  check_round_trip(scenario);
  try {
    run_steps(scenario);
  } catch (const std::invalid_argument&) {  // a start that cannot be run
  }
}

}  // namespace
}  // namespace polhode::demos

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  polhode::demos::read(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
