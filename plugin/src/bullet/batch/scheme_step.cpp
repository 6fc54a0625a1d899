#include "bullet/batch/scheme_step.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// change(lane, state) for each of the lanes, one by one.
template <class Change>
void change_lanes(const LaneBits& lanes, WideState& state, const Change& change) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    RotationState of_lane;
    get_lane(lane, state, of_lane);
    change(lane, of_lane);
    set_lane(lane, of_lane, state);
  }
}

}  // namespace

WideStepInput free_input(const Batch& batch, btScalar dt) {
  return {batch.inertia_B(), Vector3Wide::Constant(Wide(0.0)), Wide(static_cast<double>(dt))};
}

void step_lanes(const Batch& batch, const LaneBits& lanes, const WideStepInput& input, WideState& state,
                Wide* memory) {
  if (batch.wide_scheme != nullptr) {
    batch.wide_scheme->step_wide(input, wide_mask(lanes), state, memory);
    return;
  }
  change_lanes(lanes, state, [&](std::size_t lane, RotationState& of_lane) {
    StepInput input_of_lane;
    get_lane(lane, input, input_of_lane);
    batch.scheme->step(input_of_lane, of_lane);
  });
}

void turn_lanes(const Batch& batch, const LaneBits& lanes, const Vector3Wide& omega_W, btScalar dt,
                WideState& state) {
  if (batch.wide_scheme != nullptr) {
    batch.wide_scheme->turn_wide(omega_W, Wide(static_cast<double>(dt)), state);
    return;
  }
  change_lanes(lanes, state, [&](std::size_t lane, RotationState& of_lane) {
    Vector3 omega_of_lane_W;
    get_lane(lane, omega_W, omega_of_lane_W);
    batch.scheme->turn(omega_of_lane_W, static_cast<double>(dt), of_lane);
  });
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
