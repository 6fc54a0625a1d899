#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "workprecision/kernel.h"

namespace polhode::demos {

/// Kernels whose costs are set side by side.
struct Lap {
  Kernel* kernel;
  std::int64_t steps_at_most;  ///< from the start, before the kernel starts over
  std::size_t baseline;        ///< the lap to which the cost of this one is relative
};

struct Cost {
  double ns_per_step;
  double ratio;  ///< to the baseline's
};

/// The name of the contender to which costs are relative: Bullet's default.
inline constexpr char kBaseline[] = "bullet:implicit_body";

/// Measures the cost of each kernel's step on a machine that others use too. Each kernel runs for a moment in
/// each of the rounds, so that noise affects all of them equally. The figures are medians over the rounds;
/// the ratio is the median of the ratios within a round. There is no figure where the kernel or its baseline
/// may do no step.
/// @throws Interrupted
std::vector<std::optional<Cost>> measure_costs(const std::vector<Lap>& laps, std::int64_t rounds);

}  // namespace polhode::demos
