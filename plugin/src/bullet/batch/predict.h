#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// What btDiscreteDynamicsWorld::predictUnconstraintMotion does, for the dynamic bodies of the batch:
/// damping, and the predicted poses by which collision detection grows its boxes. These are Bullet's to
/// rounding: Bullet's turn by the velocity that the body shows. Returns the lanes; the others are left to
/// Bullet.
LaneBits predict(Batch& batch, const StepContext& context) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
