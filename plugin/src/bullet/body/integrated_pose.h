#pragma once

#include "bullet/batch/write_step.h"

/// Bullet does more to a pose than turn it by the angular velocity: split impulse turns it within the solver,
/// and continuous collision detection stops a body within the step, whose dt Bullet then integrates in part
/// only.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Returns whether continuous collision detection may stop the body in a step of dt. Errs towards true by
/// rounding.
bool may_be_clamped(const btRigidBody& body, btScalar dt);

/// The part of dt by which Bullet has integrated the body: less than 1 where it was stopped.
double turned_fraction(const Batch& batch, std::size_t lane, btScalar dt);

/// Turns the result of a lane by the same part of dt only.
void clamp_step(const Batch& batch, std::size_t lane, const Solved& solved, const StepContext& context,
                StepResult& result);

/// Split impulse, on by default, turns the pose of a body in contact within the solver, as an external
/// rotation. It shows when Bullet's turn of the pose written last does not give the pose found; only then is
/// the difference adopted, since in single precision it is uncertain by 1e-7 rad. A free body that a callback
/// of collision detection has turned is treated alike.
void adopt_split_impulse(Batch& batch, std::size_t lane, PoseIntegratedBy integrator, const Solved& solved,
                         const StepContext& context);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
