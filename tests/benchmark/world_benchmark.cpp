#include "benchmark/world_benchmark.h"

#include <chrono>

#include "benchmark/heap_count.h"
#include "benchmark/paired_times.h"

namespace polhode::benchmarks {

namespace {

// One of the two worlds and its counters.
class Contender {
 public:
  Contender(RotatedBy rotated_by, SchemePointer scheme)
      : rotated_by_(rotated_by), scheme_(std::move(scheme)) {}

  void tear_down() {
    if (!world_) return;
    incidents_ += world_->incidents();
    world_.reset();
  }

  void build(const SceneStart& start, const WorldBenchmark& options) {
    const std::int64_t before = heap_count().live_bytes;
    world_ = std::make_unique<SceneWorld>(start, rotated_by_, scheme_);
    kicked_ = options.kicked;
    for (int i = 0; i < options.rounds.warm_up_steps; ++i) timed_step();
    live_bytes_ = heap_count().live_bytes - before;
    allocations_ = 0;
  }

  /// Returns ns per body and step.
  double run_batch(int steps) {
    // An untimed step fills the caches again, which the other world has emptied.
    timed_step();
    double ns = 0.0;
    for (int i = 0; i < steps; ++i) ns += timed_step();
    return ns / (static_cast<double>(steps) * static_cast<double>(world_->bodies()));
  }

  std::int64_t live_bytes() const { return live_bytes_; }
  std::int64_t allocations() const { return allocations_; }
  std::uint64_t incidents() const { return incidents_; }

 private:
  double timed_step() {
    if (kicked_) world_->kick();
    const std::int64_t allocations_before = heap_count().allocations;
    const auto before = std::chrono::steady_clock::now();
    world_->step();
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - before;
    allocations_ += heap_count().allocations - allocations_before;
    return taken.count();
  }

  RotatedBy rotated_by_;
  SchemePointer scheme_;
  std::unique_ptr<SceneWorld> world_;
  bool kicked_ = false;
  std::int64_t live_bytes_ = 0;
  std::int64_t allocations_ = 0;
  std::uint64_t incidents_ = 0;
};

class Race {
 public:
  explicit Race(const WorldBenchmark& options)
      : options_(options),
        start_(options.scene()),
        plain_(RotatedBy::bullet, nullptr),
        polhode_(options.rotated_by, options.scheme) {}

  /// Returns the time of Polhode's world, s per step.
  double run_round() {
    const bool plain_first = round_ % 2 == 0;
    const int per_build = options_.rounds.rounds_per_build;
    if (round_ % per_build == 0) build(round_ / per_build % 2 == 0);
    const int steps = options_.rounds.steps_per_round;
    Contender& first = plain_first ? plain_ : polhode_;
    Contender& second = plain_first ? polhode_ : plain_;
    const double first_ns = first.run_batch(steps);
    const double second_ns = second.run_batch(steps);
    const double polhode_ns = plain_first ? second_ns : first_ns;
    times_.add_round(plain_first ? first_ns : second_ns, polhode_ns);
    ++round_;
    return polhode_ns * 1e-9 * bodies();
  }

  void report(benchmark::State& state) {
    count_allocations();
    plain_.tear_down();
    polhode_.tear_down();
    times_.report(state);
    if (!start_.floor) report_memory(state);
    state.counters[counters::kDiverged] = static_cast<double>(polhode_.incidents());
  }

 private:
  // Not for piles: contacts, and with them Bullet's memory, change at different times in the two worlds.
  void report_memory(benchmark::State& state) const {
    const auto plain_bytes = static_cast<double>(plain_.live_bytes());
    state.counters[counters::kPlainBytesPerBody] = plain_bytes / bodies();
    state.counters[counters::kBytesPerBody] =
        (static_cast<double>(polhode_.live_bytes()) - plain_bytes) / bodies();
    const int steps = round_ * (options_.rounds.steps_per_round + 1);
    state.counters[counters::kAllocationsPerStep] = static_cast<double>(extra_allocations_) / steps;
  }

  double bodies() const { return static_cast<double>(start_.boxes.size()); }

  void build(bool plain_first) {
    count_allocations();
    plain_.tear_down();
    polhode_.tear_down();
    (plain_first ? plain_ : polhode_).build(start_, options_);
    (plain_first ? polhode_ : plain_).build(start_, options_);
  }

  // Adds the allocations of the present worlds before they are torn down.
  void count_allocations() { extra_allocations_ += polhode_.allocations() - plain_.allocations(); }

  const WorldBenchmark& options_;
  SceneStart start_;
  Contender plain_;
  Contender polhode_;
  PairedTimes times_;
  int round_ = 0;
  std::int64_t extra_allocations_ = 0;
};

}  // namespace

void run_world_benchmark(benchmark::State& state, const WorldBenchmark& world_benchmark) {
  Race race(world_benchmark);
  while (state.KeepRunning()) state.SetIterationTime(race.run_round());
  race.report(state);
}

}  // namespace polhode::benchmarks
