#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

/// The stages of a batch's step, in order. The step of a lane begins in predict, or in before_solve if the
/// library does not run the prediction.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Replaces btDiscreteDynamicsWorld::predictUnconstraintMotion for the moving bodies of the batch: applies
/// damping, and writes the predicted poses, by which collision detection enlarges its boxes. These poses
/// agree with Bullet's up to rounding: Bullet's turn by the body's velocity. Returns the lanes; the others
/// are left to Bullet.
LaneBits predict(Batch& batch, const StepContext& context) noexcept;

/// Begins the step of the given lanes, right after Bullet's damping: adopts external changes and sanitizes
/// values that are not finite. A body's first step starts from its present motion. Called by predict and
/// before_solve.
void begin_step(Batch& batch, const LaneBits& lanes, const StepContext& context) noexcept;

/// Adopts external changes of the bodies since the library last wrote or adopted them.
void adopt_changes(Batch& batch, const LaneBits& lanes, const StepContext& context);

/// Sanitizes bodies that take no step of the library, so that they do not spread a NaN: diverged ones, and,
/// after Bullet's integration, those that Bullet woke or deactivated within the step.
void sanitize_left_to_bullet(Batch& batch, const LaneBits& lanes) noexcept;

/// Prepares the solve. Call right before the solver, after collision detection. Clears the gyroscopic flags
/// until the step ends, and gives the solver its start velocity:
///
///   free                            the body's velocity as it is
///   constrained, and the scheme
///     turns by the start velocity   omega
///     carries omega                 omega, and the gyroscopic change as the impulse of a torque
///     follows the free motion       resolved: the turn velocity u, with the effective inertia M
///                                   else: omega, with the plain inertia
///   with locked axes                the same, projected onto the free axes (locked_axes.h)
///
/// Adopts changes of a constrained body since predict. A velocity change of a free body counts as one by the
/// solver.
void before_solve(Batch& batch, const StepContext& context) noexcept;

/// Takes the step of the given lanes after the solve, and writes it to Bullet's bodies. Requires
/// before_solve. With v the velocity that the solver left and d = v - (the velocity given to the solver):
///
///   free, or nothing acted          the scheme's step with the kick d; shows the velocity at its end
///   constrained, and the scheme
///     turns by the start velocity   the same, but turns by v and shows v
///     carries omega                 omega' = v, q' = turn(q, v)
///     follows the free motion       resolved: q' = turn(q, u + d), L' = L + M d; shows v
///                                   else: q' = turn(q, v), L' = I(q') v, without a gyroscopic term; shows v
///   with locked axes                locked_axes.h
///
/// Restores flags, torque and inertia of a body that the solver put to sleep; such a body takes no step.
void after_solve(Batch& batch, LaneBits lanes, PoseIntegratedBy integrator,
                 const StepContext& context) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
