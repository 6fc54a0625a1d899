#pragma once

namespace polhode {

/// Past these a scheme counts as diverged. Both leave room in single precision for the products that Bullet's
/// solver forms of a body's velocity and its neighbours'.

/// rad/s. The rim of a body of one metre would be three times as fast as light.
inline constexpr double kMaximumAngularSpeed = 1e9;

/// The longest column of R_WB. Keeps the bounding box of a body of 100 m within 1e6 m, where Bullet takes a
/// body out of the simulation.
inline constexpr double kMaximumSwelling = 1e4;

}  // namespace polhode
