#pragma once

#include <benchmark/benchmark.h>

#include <functional>

#include "benchmark/scene_world.h"

namespace polhode::benchmarks {

/// The duration of the measurement of a pair of worlds. Worlds are built anew several times, because their
/// place in memory is part of the noise and the schemes that blow up have to begin again before they do.
struct WorldRounds {
  int builds;
  int rounds_per_build;
  int steps_per_round;
  int warm_up_steps;

  int rounds() const { return builds * rounds_per_build; }
};

struct WorldBenchmark {
  RotatedBy rotated_by;
  SchemePointer scheme;
  std::function<SceneStart()> scene;
  WorldRounds rounds;
  /// Before every step every body of both worlds gets a torque impulse. That is the application's doing, and
  /// not timed on either side.
  bool kicked = false;
};

/// Steps the plain world and Polhode's in turns, as many rounds as the state has iterations.
void run_world_benchmark(benchmark::State& state, const WorldBenchmark& world_benchmark);

}  // namespace polhode::benchmarks
