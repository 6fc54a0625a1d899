#include "world/run.h"

#include <chrono>
#include <vector>

#include "record/median.h"
#include "world/attitude_reference.h"
#include "world/scenario_world.h"

namespace polhode::demos {

namespace {

using Clock = std::chrono::steady_clock;

/// Computes the usual time of a step: the median over up to 1000 equal parts of a run, so that neither the
/// first steps nor interruptions by other programs count.
class StepTimer {
 public:
  explicit StepTimer(std::int64_t steps) : steps_per_stretch_((steps + kStretches - 1) / kStretches) {}

  void add(Clock::duration step) {
    in_stretch_ += step;
    if (++steps_in_stretch_ == steps_per_stretch_) end_stretch();
  }

  double median_ns() {
    if (ns_.empty()) end_stretch();
    return median(ns_);
  }

 private:
  static constexpr std::int64_t kStretches = 1000;

  void end_stretch() {
    ns_.push_back(std::chrono::duration<double, std::nano>(in_stretch_).count() /
                  static_cast<double>(steps_in_stretch_));
    in_stretch_ = {};
    steps_in_stretch_ = 0;
  }

  std::int64_t steps_per_stretch_;
  std::int64_t steps_in_stretch_ = 0;
  Clock::duration in_stretch_{};
  std::vector<double> ns_;
};

}  // namespace

Figures run(const Scenario& scenario, const Contender& contender, const SampleObserver& observe) {
  ScenarioWorld world(scenario, contender);
  Sample start = world.sample().value();
  AttitudeReference reference(scenario, world, start);
  reference.compare(start);
  FiguresRecorder recorder(start, scenario.dt);
  observe(start);
  const std::int64_t steps = step_count(scenario.dt, scenario.duration);
  StepTimer timer(steps);
  std::int64_t step = 0;
  while (step < steps) {
    const Clock::time_point before = Clock::now();
    world.step();
    timer.add(Clock::now() - before);
    ++step;
    std::optional<Sample> sample = world.sample();
    if (!sample) {
      recorder.set_diverged(static_cast<double>(step) * scenario.dt);
      break;
    }
    reference.compare(*sample);
    recorder.add(*sample);
    observe(*sample);
  }
  recorder.set_ns_per_step(timer.median_ns());
  return recorder.figures();
}

std::string bullet_precision() {
  return sizeof(btScalar) == sizeof(double) ? "double" : "single";
}

}  // namespace polhode::demos
