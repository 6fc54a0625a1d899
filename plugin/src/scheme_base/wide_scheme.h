#pragma once

#include <cstddef>

#include "polhode/rotation_scheme.h"
#include "scheme_base/wide_state.h"

namespace polhode {

/// One row of what a scheme keeps of eight bodies between steps, a number for each lane. A lane that is 0 in
/// all rows is empty.
using WideMemoryRow = Wide;

/// A scheme that steps eight bodies at once. A lane's result does not depend on the other lanes.
class WideScheme : public RotationScheme {
 public:
  /// The number of rows of memory that the scheme wants for eight bodies.
  virtual std::size_t memory_rows() const noexcept { return 0; }

  /// `step` of eight bodies. Only lanes in `mask` count: the caller discards the state of the others, which
  /// may start from anything, NaN included.
  /// memory: memory_rows() rows, or null to remember nothing. Lanes outside the mask keep their memory. The
  /// memory is for shortcuts only: without it the result is the same up to rounding. Its holder zeroes a lane
  /// when another body or another inertia comes into it.
  virtual void step_wide(const WideStepInput& input, const WideMask& mask, WideState& state,
                         WideMemoryRow* memory) const noexcept = 0;

  /// `turn` of eight bodies. Default: the exponential map.
  virtual void turn_wide(const Vector3Wide& omega_W, const Wide& dt, WideState& state) const noexcept;

  /// Through step_wide without a memory.
  void step(const StepInput& input, RotationState& state) const noexcept final;
  /// Through turn_wide.
  void turn(const Vector3& omega_W, double dt, RotationState& state) const noexcept final;
};

}  // namespace polhode
