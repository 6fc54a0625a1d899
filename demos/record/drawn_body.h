#pragma once

#include <optional>
#include <vector>

#include "polhode/rotation_state.h"

namespace polhode::demos {

/// A box of a body, in body axes, m.
struct DrawnBox {
  Vector3 half_extents;
  Vector3 at_B;
  Quaternion q_BP;  ///< rotates the box's axes into the body's
};

/// The shape that is drawn for a body: a sphere, or boxes.
struct DrawnBody {
  std::optional<double> radius;
  std::vector<DrawnBox> boxes;
};

}  // namespace polhode::demos
