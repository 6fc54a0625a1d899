#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

/// The stages of a batch's step, in their order. A step of a lane begins in predict or, where the library
/// does not see that stage, in before_solve.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Does what btDiscreteDynamicsWorld::predictUnconstraintMotion does for the bodies of the batch that move:
/// applies damping, and writes the predicted poses by which collision detection grows its boxes. These are
/// Bullet's to rounding: Bullet's turn by the velocity that the body shows. Returns the lanes; the others are
/// left to Bullet.
LaneBits predict(Batch& batch, const StepContext& context) noexcept;

/// Begins the step of lanes whose body moves, right after Bullet's damping: adopts external changes and takes
/// out what is not finite. A body's first step starts from its present motion. predict and before_solve call
/// it.
void begin_step(Batch& batch, const LaneBits& lanes, const StepContext& context) noexcept;

/// Adopts what somebody changed of the lanes' bodies since the library last wrote or adopted it.
void adopt_changes(Batch& batch, const LaneBits& lanes, const StepContext& context);

/// Keeps bodies that take no step of the library's from spreading a NaN: diverged ones, and after Bullet's
/// integration those that Bullet woke or switched off within the step.
void sanitize_left_to_bullet(Batch& batch, const LaneBits& lanes) noexcept;

/// Right before the solver, when collision detection is done: clears the gyroscopic flags until the step
/// ends, and gives the solver the velocity it should start from:
///
///   free                            the body's velocity as it is
///   constrained, and the scheme
///     turns by the start velocity   omega
///     carries omega                 omega, and the gyroscopic change as the impulse of a torque
///     follows the free motion       resolved: the turn velocity u, with the effective inertia M
///                                   else: omega, with the plain inertia
///   held about an axis              the same, without what the axis forbids (locked_axes.h)
///
/// Adopts what changed a constrained body since predict; a change of a free one's velocity counts as
/// one by the solver.
void before_solve(Batch& batch, const StepContext& context) noexcept;

/// After the solver: takes the step of the lanes given, which have been through before_solve, and writes it
/// to Bullet's bodies. With v the velocity that the solver left and d = v - (the one it was given):
///
///   free, or nothing acted          the scheme's step with the kick d; shows the velocity at its end
///   constrained, and the scheme
///     turns by the start velocity   the same, but shows v, by which it turns
///     carries omega                 omega' = v, q' = turn(q, v)
///     follows the free motion       resolved: q' = turn(q, u + d), L' = L + M d; shows v
///                                   else: q' = turn(q, v), L' = I(q') v, without a gyroscopic term; shows v
///   held about an axis              locked_axes.h
///
/// A body that the solver put to sleep gets back what the solver had others for, and takes no step.
void after_solve(Batch& batch, LaneBits lanes, PoseIntegratedBy integrator,
                 const StepContext& context) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
