#pragma once

#include <optional>

#include "record/sample.h"

/// The distance of a sample from what free motion keeps. There is no error where the start has no energy, or
/// no momentum, to compare with.
namespace polhode::demos {

/// Returns E/E0 - 1.
std::optional<double> energy_error(const Sample& sample, const Sample& start);
/// |L|/|L0| - 1
std::optional<double> momentum_error(const Sample& sample, const Sample& start);
/// Returns the angle between L and L0.
std::optional<double> momentum_angle_rad(const Sample& sample, const Sample& start);

/// Returns true if |omega| dt > pi/4: Bullet's own turn is cut there.
bool is_past_cut(const Sample& sample, double dt);

}  // namespace polhode::demos
