#pragma once

namespace polhode::run {

/// The shared library of Bullet that each adapter is linked to; empty for an adapter that was not built. Defined by
/// the build, which asks the adapters.
extern const char kExpectedBullet32[];
extern const char kExpectedBullet64[];

}  // namespace polhode::run
