#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// The second moment of a step, after the solver: takes the step of the lanes given, which before_solve has
/// begun, and writes it to Bullet's bodies. With v the velocity that the solver left and d = v - (the one it
/// was given):
///
///   free, or nothing acted          the scheme's step with the kick d; shows the velocity at its end
///   constrained, and the scheme
///     turns by the start velocity   the same, but shows v, by which it turns
///     carries omega                 omega' = v, q' = turn(q, v)
///     follows the free motion       tame: q' = turn(q, u + d), L' = L + M d; shows v
///                                   else: q' = turn(q, v), L' = I(q') v, without a gyroscopic term; shows v
///   held about an axis              locked_axes.h
///
/// A body that the solver put to sleep gets back what the solver had others for, and takes no step.
void after_solve(Batch& batch, LaneBits lanes, PoseIntegratedBy integrator,
                 const StepContext& context) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
