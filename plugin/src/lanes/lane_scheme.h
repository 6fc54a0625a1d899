#pragma once

#include <array>
#include <cstddef>

#include "lanes/lane_step.h"
#include "polhode/rotation_scheme.h"

namespace polhode {

/// Of the bodies in the first `count` lanes; the other lanes have one of them once more.
struct LaneMemories {
  std::array<SchemeMemory*, kLanes> of;
  std::size_t count;
};

/// A scheme that steps eight bodies at once in lanes. Whoever holds the bodies in lanes calls step_lanes; the
/// rest of RotationScheme stands on it.
class LaneScheme : public RotationScheme {
 public:
  /// One step of the bodies, on none of which a torque acts alone (StepInput::torque_W).
  virtual void step_lanes(const LaneInput& input, LaneState& state,
                          const LaneMemories& memories) const noexcept = 0;

  void step(const StepInput& input, RotationState& state) const noexcept final;
  void step_with_memory(const StepInput& input, RotationState& state,
                        SchemeMemory& memory) const noexcept final;
  void step_bodies(const BodyStep* bodies, std::size_t count) const noexcept override;

 private:
  void step_block(const BodyStep* bodies, std::size_t count) const noexcept;
};

}  // namespace polhode
