#pragma once

#include <benchmark/benchmark.h>

#include <functional>

#include "benchmark/scene_world.h"

namespace polhode::benchmarks {

/// How long a pair of worlds is measured. The worlds are built several times because their place in memory is
/// part of the noise, and because some schemes would diverge in a longer run.
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
  /// Applies a torque impulse to every body of both worlds before every step, outside the timed part.
  bool kicked = false;
};

/// Steps the plain world and Polhode's alternately, one round per iteration of `state`.
void run_world_benchmark(benchmark::State& state, const WorldBenchmark& world_benchmark);

}  // namespace polhode::benchmarks
