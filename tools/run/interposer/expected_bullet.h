#pragma once

namespace polhode::run {

/// The shared Bullet library to which each adapter is linked; empty for an adapter that was not built.
/// Defined in a generated source, see expected_bullet.cmake.
extern const char kExpectedBullet32[];
extern const char kExpectedBullet64[];

}  // namespace polhode::run
