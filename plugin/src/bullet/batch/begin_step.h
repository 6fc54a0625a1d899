#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Begins the step of lanes whose body moves, right after Bullet's damping: adopts external changes and takes
/// out what is not finite. A body's first step starts from its present motion.
void begin_step(Batch& batch, const LaneBits& lanes, const StepContext& context) noexcept;

/// Adopts what somebody changed of the lanes' bodies since the library last wrote or adopted it.
void adopt_changes(Batch& batch, const LaneBits& lanes, const StepContext& context);

/// Replaces what is not finite by what the library wrote last, and notes the incident.
void sanitize_lane(Batch& batch, std::size_t lane);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
