#pragma once

#include "bullet/batch/batch.h"

/// The scheme of a batch, for the lanes given. A scheme that does not step eight bodies at once is called
/// lane by lane.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Without a kick.
WideStepInput free_input(const Batch& batch, btScalar dt);

/// RotationScheme::step. The other lanes of `state` are left undefined. memory: the batch's, or null.
void step_lanes(const Batch& batch, const LaneBits& lanes, const WideStepInput& input, WideState& state,
                Wide* memory);

/// RotationScheme::turn.
void turn_lanes(const Batch& batch, const LaneBits& lanes, const Vector3Wide& omega_W, btScalar dt,
                WideState& state);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
