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

/// What a step of each kernel costs, on a machine that others use too: in each of the rounds each kernel runs
/// for a moment, so that a slow spell meets all of them; the figures are medians over the rounds, the ratio
/// that of the ratios within a round. None where the kernel or its baseline may do no step.
/// @throws Interrupted
std::vector<std::optional<Cost>> measure_costs(const std::vector<Lap>& laps, std::int64_t rounds);

}  // namespace polhode::demos
