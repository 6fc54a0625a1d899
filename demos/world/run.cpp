#include "world/run.h"

#include <chrono>

#include "world/scenario_world.h"

namespace polhode::demos {

namespace {

using Clock = std::chrono::steady_clock;

double ns_per_step(Clock::duration in_steps, std::int64_t steps) {
  return std::chrono::duration<double, std::nano>(in_steps).count() / static_cast<double>(steps);
}

}  // namespace

Figures run(const Scenario& scenario, const Contender& contender, const SampleObserver& observe) {
  ScenarioWorld world(scenario, contender);
  const Sample start = world.sample().value();
  FiguresRecorder recorder(start, scenario.dt);
  observe(start);
  const std::int64_t steps = step_count(scenario.dt, scenario.duration);
  Clock::duration in_steps{};
  std::int64_t step = 0;
  while (step < steps) {
    const Clock::time_point before = Clock::now();
    world.step();
    in_steps += Clock::now() - before;
    ++step;
    const std::optional<Sample> sample = world.sample();
    if (!sample) {
      recorder.set_diverged(static_cast<double>(step) * scenario.dt);
      break;
    }
    recorder.add(*sample);
    observe(*sample);
  }
  recorder.set_ns_per_step(ns_per_step(in_steps, step));
  return recorder.figures();
}

std::string bullet_precision() {
  return sizeof(btScalar) == sizeof(double) ? "double" : "single";
}

}  // namespace polhode::demos
