#pragma once

#include <benchmark/benchmark.h>

#include "polhode/scheme_registry.h"

namespace polhode::benchmarks {

inline constexpr int kKernelRounds = 201;

enum class KernelMotion {
  free,    ///< the scheme's memory stays valid
  set_up,  ///< a small alternating change in every step invalidates the scheme's memory
};

/// Steps 1,024 bodies without a world. Compares the scheme, or Bullet's code itself if `scheme` is null, with
/// Bullet's implicit gyroscopic term and exponential map.
void run_kernel_benchmark(benchmark::State& state, const SchemePointer& scheme, KernelMotion motion);

}  // namespace polhode::benchmarks
