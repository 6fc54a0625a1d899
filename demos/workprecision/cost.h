#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workprecision/cost_rounds.h"
#include "workprecision/options.h"

namespace polhode::demos {

/// The cost of a contender's step, in free motion and with a kick in every step. Absent if the body diverges
/// within a few steps.
struct ContenderCost {
  std::string contender;
  std::optional<Cost> free;
  std::optional<Cost> kicked;
};

/// Runs the measurement that the options describe and writes its files.
std::vector<ContenderCost> costs(const CostOptions& options);

/// Return the results as text; docs/work_precision.md documents columns and keys.
std::string cost_table(const std::vector<ContenderCost>& costs);
std::string cost_csv(const std::vector<ContenderCost>& costs);
std::string cost_json(const std::vector<ContenderCost>& costs);

}  // namespace polhode::demos
