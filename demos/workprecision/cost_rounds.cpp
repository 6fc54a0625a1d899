#include "workprecision/cost_rounds.h"

#include <algorithm>
#include <chrono>

#include "command_line/interruption.h"
#include "record/median.h"

namespace polhode::demos {

namespace {

// Some 0.1 to 1 ms: long compared with reading the clock, short compared with a time slice of the scheduler.
constexpr std::int64_t kStepsPerRound = 1000;

double ns_per_step(const Lap& lap) {
  const std::int64_t steps = std::min(kStepsPerRound, lap.steps_at_most);
  const std::int64_t laps = kStepsPerRound / steps;
  const auto before = std::chrono::steady_clock::now();
  for (std::int64_t i = 0; i < laps; ++i) {
    lap.kernel->restart();
    lap.kernel->run(steps);
  }
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - before;
  return taken.count() / static_cast<double>(laps * steps);
}

}  // namespace

std::vector<std::optional<Cost>> measure_costs(const std::vector<Lap>& laps, std::int64_t rounds) {
  std::vector<std::vector<double>> ns(laps.size());
  std::vector<std::vector<double>> ratios(laps.size());
  std::vector<double> now(laps.size());
  // The first round warms up the caches.
  for (std::int64_t round = -1; round < rounds; ++round) {
    for (std::size_t i = 0; i < laps.size(); ++i) {
      throw_if_interrupted();
      if (laps[i].steps_at_most > 0) now[i] = ns_per_step(laps[i]);
    }
    if (round < 0) continue;
    for (std::size_t i = 0; i < laps.size(); ++i) {
      ns[i].push_back(now[i]);
      ratios[i].push_back(now[i] / now[laps[i].baseline]);
    }
  }
  std::vector<std::optional<Cost>> costs(laps.size());
  for (std::size_t i = 0; i < laps.size(); ++i) {
    if (laps[i].steps_at_most == 0 || laps[laps[i].baseline].steps_at_most == 0) continue;
    costs[i] = Cost{median(ns[i]), median(ratios[i])};
  }
  return costs;
}

}  // namespace polhode::demos
