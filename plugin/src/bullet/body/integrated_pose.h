#pragma once

#include "bullet/batch/write_step.h"

/// Bullet changes a pose in more ways than by the angular velocity: split impulse rotates it within the
/// solver, and continuous collision detection clamps the step of a body, so that Bullet integrates only a
/// part of dt.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Returns true if continuous collision detection may clamp the body in a step of dt. May return true for a
/// body just below the threshold.
bool may_be_clamped(const btRigidBody& body, btScalar dt);

/// Returns the fraction of dt by which Bullet has integrated the body: less than 1 if the body was clamped.
double turned_fraction(const Batch& batch, std::size_t lane, btScalar dt);

/// Limits the turn in the result of a lane to the same fraction of dt.
void clamp_step(const Batch& batch, std::size_t lane, const Solved& solved, const StepContext& context,
                StepResult& result);

/// Adopts the rotation by split impulse, which is on by default and rotates the pose of a body in contact
/// within the solver, as an external rotation. There is one if Bullet's turn of the written pose does not
/// give the pose found. Only then is the difference adopted, since in single precision it is uncertain by
/// 1e-7 rad. Also adopts a rotation of a free body by a callback of collision detection.
void adopt_split_impulse(Batch& batch, std::size_t lane, PoseIntegratedBy integrator, const Solved& solved,
                         const StepContext& context);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
