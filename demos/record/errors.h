#pragma once

#include <optional>

#include "record/sample.h"

/// How far a sample is from what free motion keeps. Nothing where the start has no energy, or no momentum, to
/// compare with.
namespace polhode::demos {

/// E/E0 - 1
std::optional<double> energy_error(const Sample& sample, const Sample& start);
/// |L|/|L0| - 1
std::optional<double> momentum_error(const Sample& sample, const Sample& start);
/// Between L and L0.
std::optional<double> momentum_angle_rad(const Sample& sample, const Sample& start);

/// Whether |omega| dt > pi/4: Bullet's own turn is cut there.
bool is_past_cut(const Sample& sample, double dt);

}  // namespace polhode::demos
