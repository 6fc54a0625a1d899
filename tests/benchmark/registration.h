#pragma once

namespace polhode::benchmarks {

/// Registers these benchmarks with Google Benchmark:
///
///    world/SCHEME/free/N     RotationWorld, N boxes in free flight
///    world/SCHEME/kicked/N   the same, with a torque impulse on every box before every step
///    world/SCHEME/pile/N     RotationWorld, a settled pile that stays awake
///    plugin/SCHEME/...       the same with RotationPlugin
///    control/bullet/free/N   two plain worlds; shows the uncertainty of the ratio
///    kernel/SCHEME/free      the scheme alone
///    kernel/SCHEME/set_up    the same, with a change in every step
///    kernel/bullet           Bullet's kernel against itself; shows the uncertainty of the ratio
///
/// N is 100, for quick trials, and larger. Each round is one iteration, and the number of rounds is fixed:
/// --benchmark_min_time has no effect.
void register_benchmarks();

}  // namespace polhode::benchmarks
