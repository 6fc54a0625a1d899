#pragma once

#include <optional>

#include "record/sample.h"

/// Measures how far a sample is from what free motion conserves. Returns nothing if the start has no energy
/// or momentum to compare with.
namespace polhode::demos {

/// Returns E/E0 - 1.
std::optional<double> energy_error(const Sample& sample, const Sample& start);
/// Returns |L|/|L0| - 1.
std::optional<double> momentum_error(const Sample& sample, const Sample& start);
/// Returns the angle between L and L0.
std::optional<double> momentum_angle_rad(const Sample& sample, const Sample& start);

/// Returns true if |omega| dt > pi/4, where Bullet limits the turn of a step.
bool is_past_cut(const Sample& sample, double dt);

}  // namespace polhode::demos
