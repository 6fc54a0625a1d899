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
};

/// The axes of the body, omega and L as they are shown. `radius` is the body's, m. omega and L are as long as
/// 1.6 radii where they have the length they started with, and no longer than 2.2.
std::vector<Arrow> arrows_of(const Sample& sample, const Sample& start, double radius);

/// How far the body reaches from its centre of mass, m.
double reach_of(const Body& body);

}  // namespace polhode::demos
