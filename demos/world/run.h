#pragma once

#include <functional>
#include <string>

#include "record/contender.h"
#include "record/figures.h"

namespace polhode::demos {

/// Gets every sample of a run in turn, the start included. An exception ends the run.
using SampleObserver = std::function<void(const Sample&)>;

/// Runs the scenario with this contender to its end or to the divergence. Samples are not kept.
/// @throws std::invalid_argument for a start that start_motion refuses
Figures run(const Scenario& scenario, const Contender& contender, const SampleObserver& observe);

/// The precision of the Bullet that this is built with: "single" or "double".
std::string bullet_precision();

}  // namespace polhode::demos
