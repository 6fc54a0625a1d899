#pragma once

#include "polhode/rotation_state.h"

namespace polhode::oracle {

/// A symmetric top with a fixed point on its axis, under gravity along -z; SI units.
struct HeavyTop {
  double transverse;  ///< moment about a transverse axis through the centre of mass
  double axial;       ///< moment about the symmetry axis
  double mass;
  double length;   ///< distance from the fixed point, the origin, to the centre of mass
  double gravity;  ///< m/s^2
};

/// Returns the slower of the two rates (rad/s, about z) at which a top tilted by `tilt` from the vertical
/// precesses steadily. `spin` is the component of its angular velocity along its symmetry axis.
/// @throws std::invalid_argument if the top spins too slowly to precess steadily.
double slow_precession(const HeavyTop& top, double tilt, double spin);

/// A steadily precessing top, at the moment when its axis leans towards x.
struct SteadyTop {
  Vector3 axis_W;
  Vector3 omega_W;
  Vector3 velocity_W;  ///< of the centre of mass
};

SteadyTop steadily_precessing(const HeavyTop& top, double tilt, double spin);

}  // namespace polhode::oracle
