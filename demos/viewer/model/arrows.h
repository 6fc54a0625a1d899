#pragma once

#include <vector>

#include "viewer/model/palette.h"
#include "viewer/model/simulation.h"

namespace polhode::demos {

struct Arrow {
  const char* name;
  Vector3 from_W;
  Vector3 along_W;  ///< its whole length, m
  Color color;
  double thickness = 1.0;  ///< of the usual one
};

/// The axes of the body, omega and L as they are shown, and h, the momentum of rotors, where there are some. `radius` is
/// the body's, m. omega is as long as 1.6 radii where it has the length it started with, L as 1.3, h on the scale of L,
/// and none is longer than 2.2. L is thicker than omega, and h than L, so that they are seen where they are parallel.
std::vector<Arrow> arrows_of(const Sample& sample, const Sample& start, double radius);

/// Returns how far the body reaches from its centre of mass, m.
double reach_of(const Body& body);

}  // namespace polhode::demos
