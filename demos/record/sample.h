#pragma once

#include <cstdint>

#include "polhode/rotation_state.h"

namespace polhode::demos {

/// The recorded body after one step; step 0 is the start.
struct Sample {
  std::int64_t step = 0;
  double t_s = 0.0;
  RotationState state;
  /// Rotational, translational and potential; the latter is zero at the height of the world's origin.
  double energy_J = 0.0;

  double det_R() const { return state.R_WB.determinant(); }
  bool all_finite() const;
};

}  // namespace polhode::demos
