#pragma once

namespace polhode::benchmarks {

/// Registers with Google Benchmark, by these names:
///
///     world/SCHEME/free/N     RotationWorld, N boxes in free flight
///     world/SCHEME/kicked/N   the same, with a torque impulse on every box before every step
///     world/SCHEME/pile/N     RotationWorld, a settled pile that stays awake
///     plugin/SCHEME/...       the same with RotationPlugin
///     control/bullet/free/N   a second plain world in the place of Polhode's: what the ratio is worth
///     kernel/SCHEME/free      the scheme alone
///     kernel/SCHEME/set_up    the same, with a change in every step
///     kernel/bullet           Bullet's kernel against itself: what the ratio is worth
///
/// N is 100, to try things out, and more. Each is an iteration for each round, fixed, whatever
/// --benchmark_min_time says.
void register_benchmarks();

}  // namespace polhode::benchmarks
