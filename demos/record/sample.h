#pragma once

#include <cstdint>
#include <optional>

#include "polhode/rotation_state.h"

namespace polhode::demos {

/// The recorded body after one step; step 0 is the start.
struct Sample {
  std::int64_t step = 0;
  double t_s = 0.0;
  RotationState state;
  Vector3 position_W = Vector3::Zero();  ///< of the centre of mass, m
  /// Rotational, translational and potential energy; the potential is zero at the height of the world's
  /// origin.
  double energy_J = 0.0;
  /// Angle between q_WB and the orientation of the exact motion from the start, if that is known.
  std::optional<double> attitude_error_rad = std::nullopt;

  double det_R() const { return state.R_WB.determinant(); }
  bool all_finite() const;
};

}  // namespace polhode::demos
