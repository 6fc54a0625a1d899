#pragma once

#include <vector>

#include "viewer/model/palette.h"
#include "viewer/model/simulation.h"

namespace polhode::demos {

struct Arrow {
  const char* name;
  Vector3 from_W;
  Vector3 along_W;  ///< the whole arrow, m
  Color color;
  double thickness = 1.0;  ///< relative to the usual thickness
};

/// Returns the body's axes, omega, L and, if the body has rotors, their momentum h. `radius` is the body's,
/// m. At its initial magnitude omega is 1.6 radii long and L 1.3; h has the scale of L; none is longer than
/// 2.2. L is thicker than omega, and h than L, so that all are visible where they are parallel.
std::vector<Arrow> arrows_of(const Sample& sample, const Sample& start, double radius);

/// Returns how far the body reaches from its centre of mass, m.
double reach_of(const Body& body);

}  // namespace polhode::demos
