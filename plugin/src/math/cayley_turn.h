#pragma once

#include "polhode/rotation_state.h"

/// The turn of implicit_midpoint and of the two Moser-Veselov schemes in a step. In terms of the Cayley
/// vector a = tan(angle/2) axis, their equations differ by one factor:
///
///   m + a x m = (dt/2) L_B (1 + stretch |a|^2),  m = I_B a + (dt/2) h
///
/// The midpoint rule has stretch 0. Moser and Veselov have stretch 1: a midpoint step of length
/// dt (1 + |a|^2). In both cases the momenta before and after the turn are, up to a common factor, m + a x m
/// and m - a x m. These have the same length, since a x m is normal to m, and the same energy, since a x m is
/// normal to a. h is the momentum of the rotors.
namespace polhode::formulas {

struct CayleyEquation {
  Vector3 inertia_B;
  Vector3 half_impulse_B;  ///< (dt/2) L_B, kg m^2
  Vector3 half_rotor_B;    ///< (dt/2) h, kg m^2
  double stretch;
};

/// Returns the turn of a step, (1, a)/sqrt(1 + |a|^2). The root a is found to rounding by Newton's method
/// with a line search, starting at (dt/2) omega_B. The result is not finite if no root is found. For short
/// steps it is the root that starts at a = 0 for dt = 0. `inertia_B` are the moments that define omega_B;
/// those of the equation may differ.
Quaternion cayley_turn_B(const CayleyEquation& equation, const Vector3& inertia_B);

}  // namespace polhode::formulas
