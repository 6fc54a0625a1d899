#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// The first moment of a step, right before the solver: collision detection is done.
///
/// Of each body that moves and whose step has not begun: takes what is not finite out, adopts external
/// changes, clears the gyroscopic flags until the step ends, and gives the solver the velocity it should
/// start from:
///
///   free                            the body's velocity as it is
///   constrained, and the scheme
///     turns by the start velocity   omega
///     carries omega                 omega, and the gyroscopic change as the impulse of a torque
///     follows the free motion       tame: the turn velocity u, with the effective inertia M
///                                   else: omega, with the plain inertia
///   held about an axis              the same, without what the axis forbids (locked_axes.h)
void before_solve(Batch& batch, const StepContext& context) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
