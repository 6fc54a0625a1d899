#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "workprecision/kernel.h"

namespace polhode::demos {

/// Kernels whose costs are compared.
struct Lap {
  Kernel* kernel;
  std::int64_t steps_at_most;  ///< number of steps before the kernel is restarted
  std::size_t baseline;        ///< index of the lap that this one is compared with
};

struct Cost {
  double ns_per_step;
  double ratio;  ///< relative to the baseline
};

/// Returns the name of the contender that costs are relative to: Bullet's default.
inline constexpr char kBaseline[] = "bullet:implicit_body";

/// Measures the cost of each kernel's step on a machine that runs other programs too. Each kernel runs for a
/// moment in each of the rounds, so that noise affects all of them equally. The figures are medians over the
/// rounds; the ratio is the median of the ratios within a round. There is no figure if the kernel or its
/// baseline cannot do a step.
/// @throws Interrupted
std::vector<std::optional<Cost>> measure_costs(const std::vector<Lap>& laps, std::int64_t rounds);

}  // namespace polhode::demos
