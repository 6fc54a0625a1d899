#pragma once

#include <cstddef>

#include "polhode/rotation_scheme.h"
#include "scheme_base/wide_state.h"

namespace polhode {

/// One row of a scheme's memory, which is kept between steps: one number for each of eight bodies. A lane
/// with 0 in all rows is empty.
using WideMemoryRow = Wide;

/// A scheme that steps eight bodies at once. A lane's result does not depend on the other lanes.
class WideScheme : public RotationScheme {
 public:
  /// Returns the number of rows of memory that the scheme needs for eight bodies.
  virtual std::size_t memory_rows() const noexcept { return 0; }

  /// Calls `step` for eight bodies. Only lanes in `mask` count: the caller discards the state of the other
  /// lanes, which may hold any values, including NaN. `memory` has memory_rows() rows, or is null. Lanes
  /// outside the mask keep their memory. The memory only saves time: without it the result is the same up to
  /// rounding. The caller zeroes a lane when its body or inertia changes.
  virtual void step_wide(const WideStepInput& input, const WideMask& mask, WideState& state,
                         WideMemoryRow* memory) const noexcept = 0;

  /// Calls `turn` for eight bodies. The default is the exponential map.
  virtual void turn_wide(const Vector3Wide& omega_W, const Wide& dt, WideState& state) const noexcept;

  /// Calls step_wide without a memory.
  void step(const StepInput& input, RotationState& state) const noexcept final;
  /// Calls turn_wide.
  void turn(const Vector3& omega_W, double dt, RotationState& state) const noexcept final;
};

}  // namespace polhode
