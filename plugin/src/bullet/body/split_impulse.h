#pragma once

#include "bullet/batch/write_step.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Split impulse, on by default, turns the pose of a body in contact within the solver, as an external
/// rotation. It shows when Bullet's turn of the pose written last does not give the pose found; only then is
/// the difference adopted, since in single precision it is uncertain by 1e-7 rad. A free body that a callback
/// of collision detection has turned is treated alike.
void adopt_split_impulse(Batch& batch, std::size_t lane, PoseIntegratedBy integrator, const Solved& solved,
                         const StepContext& context);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
