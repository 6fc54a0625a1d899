#pragma once

#include <array>

#include "oracle/many_digits.h"

/// The curve that L follows in the body, and its frame P; free_top.cpp has the formulas.
namespace polhode::oracle {

struct Axis {
  int index = 0;
  int sign = 1;
};

/// P's axes, as axes of B.
using Axes = std::array<Axis, 3>;

/// Returns P's axes for this start.
Axes polhode_axes(const Triple<Wide>& inertia_B, const Triple<Wide>& L_B);

Rotation<Real> rotation_of(const Axes& axes);

/// Constants of the polhode.
struct Polhode {
  Real I1, I3;              ///< moments, in the order of P's axes
  Real L;                   ///< |L|
  Real sine, cosine;        ///< C/|L| and A/|L|, of the angle between L and the plane 1-2 at u = 0
  Real m = 0, m1 = 1;       ///< the parameter k^2, and 1 - k^2
  Real nu = 0;              ///< du/dt
  Real u0_sine = 0;         ///< sn u0
  Real u0_cosine = 1;       ///< cn u0, at least 0
  Real u0_delta = 1;        ///< dn u0
  Real s_sine_squared = 0;  ///< sine squared of the amplitude of s
  Real s_cosine_squared = 1;
};

/// Returns the polhode through L_B.
Polhode polhode_of(const Triple<Wide>& inertia_B, const Triple<Wide>& L_B, const Axes& axes);

}  // namespace polhode::oracle
