#include "bullet/batch/driven_lanes.h"

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"
#include "bullet/body/external_changes.h"
#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

void DrivenLanes::move_from(const DrivenLanes& other, std::size_t from, std::size_t to) {
  starts[to] = other.starts[from];
  last_torques[to] = other.last_torques[from];
  law_failed.set(to, other.law_failed[from]);
  gain_W[to] = other.gain_W[from];
  rotor_end_B[to] = other.rotor_end_B[from];
}

LaneBits DrivenLanes::acting(const LaneBits& lanes) const {
  LaneBits result;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    result.set(lane, lanes[lane] && drives[lane] != nullptr && drives[lane]->acts());
  }
  return result;
}

Vector3Wide DrivenLanes::rotor_momentum_B() const {
  Vector3Wide result = Vector3Wide::Constant(Wide(0.0));
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (drives[lane] != nullptr) set_lane(lane, drives[lane]->rotor_momentum_B, result);
  }
  return result;
}

void begin_drive(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  DrivenLanes& driven = *batch.driven;
  driven.law_failed &= ~lanes;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    driven.starts[lane] = {context.time_s, to_double(vector_in_lane(batch.origin, lane)),
                           to_double(batch.bodies[lane]->getLinearVelocity())};
  }
}

void keep_gain(Batch& batch, const LaneBits& lanes, const WideState& end) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    RotationState end_of_lane;
    get_lane(lane, end, end_of_lane);
    batch.driven->gain_W[lane] = end_of_lane.L_W - batch.state(lane).L_W;
    batch.driven->rotor_end_B[lane] = end_of_lane.rotor_momentum_B;
  }
}

Vector3Wide omega_with_gain_W(const Batch& batch) {
  Vector3Wide result = batch.omega_W;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (batch.bodies[lane] == nullptr) continue;
    const DrivenLanes& driven = *batch.driven;
    const RotationState start = batch.state(lane);
    const Vector3 of_rotor_W = start.R_WB * (driven.rotor_end_B[lane] - start.rotor_momentum_B);
    const Vector3 inertia_B = moments_B(vector_in_lane(batch.inverse_inertia_B, lane));
    const Vector3 change_W = inverse_inertia_W(start.R_WB, inertia_B) * (driven.gain_W[lane] - of_rotor_W);
    set_lane(lane, Vector3(start.omega_W + change_W), result);
  }
  return result;
}

Vector3Wide rotor_end_B(const Batch& batch, const LaneBits& lanes) {
  Vector3Wide result = batch.driven->rotor_momentum_B();
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (lanes[lane]) set_lane(lane, batch.driven->rotor_end_B[lane], result);
  }
  return result;
}

Vector3Wide gain_W(const Batch& batch) {
  Vector3Wide result;
  for (std::size_t lane = 0; lane < kLanes; ++lane) set_lane(lane, batch.driven->gain_W[lane], result);
  return result;
}

void end_drive(Batch& batch, const LaneBits& lanes, const WideState& end) {
  DrivenLanes& driven = *batch.driven;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    Drive& drive = *driven.drives[lane];
    if (end.rotor_momentum_B) get_lane(lane, *end.rotor_momentum_B, drive.rotor_momentum_B);
    drive.last_torque = driven.last_torques[lane];
    if (driven.law_failed[lane]) batch.note(lane, IncidentKind::torque_law_failed);
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
