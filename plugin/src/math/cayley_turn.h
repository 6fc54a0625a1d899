#pragma once

#include "polhode/rotation_state.h"

/// The turn that implicit_midpoint and the two schemes of Moser and Veselov make in a step. In its Cayley
/// vector a = tan(angle/2) axis their equations differ by one factor:
///
///   m + a x m = (dt/2) L_B (1 + stretch |a|^2),  m = I_B a + (dt/2) h
///
/// The midpoint rule has stretch 0, Moser and Veselov have 1: theirs is a midpoint step of length
/// dt (1 + |a|^2). Either way the momenta before and after the turn are, but for a common factor, m + a x m
/// and m - a x m. They have the same length, since a x m is normal to m, and the same energy, since it is normal
/// to a. h is the momentum of the rotors.
namespace polhode::formulas {

struct CayleyEquation {
  Vector3 inertia_B;
  Vector3 half_impulse_B;  ///< (dt/2) L_B, kg m^2
  Vector3 half_rotor_B;    ///< (dt/2) h, kg m^2
  double stretch;
};

/// The turn of a step, (1, a)/sqrt(1 + |a|^2), a the root that Newton's method with a line search finds from
/// (dt/2) omega_B, to rounding; not finite where it finds none. Short steps get the root that grows out of
/// a = 0 with dt. `inertia_B` are the moments that omega_B goes by; the equation may have others.
Quaternion cayley_turn_B(const CayleyEquation& equation, const Vector3& inertia_B);

}  // namespace polhode::formulas
