#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "record/contender.h"
#include "report/report.h"

namespace polhode::demos {

/// Gets every sample of each contender in turn, the start included. An exception ends the runs.
using ContenderObserver = std::function<void(std::size_t contender, const Sample& sample)>;

/// Runs the scenario with each contender. The report shows `command`.
/// @throws std::invalid_argument as resolved
Report run_side_by_side(const Scenario& scenario, const ChosenContenders& chosen, const std::string& command,
                        const ContenderObserver& observe);

}  // namespace polhode::demos
