#pragma once

#include <benchmark/benchmark.h>

#include "polhode/scheme_registry.h"

namespace polhode::benchmarks {

inline constexpr int kKernelRounds = 201;

enum class KernelMotion {
  free,    ///< what a scheme keeps in its memory stays good
  set_up,  ///< a small change in every step, to and fro: whatever a scheme keeps has to be found anew
};

/// Steps 1,024 bodies without any world: Bullet's implicit gyroscopic term and exponential map against the
/// scheme, or against themselves if it is null.
void run_kernel_benchmark(benchmark::State& state, const SchemePointer& scheme, KernelMotion motion);

}  // namespace polhode::benchmarks
