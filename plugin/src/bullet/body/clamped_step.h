#pragma once

#include "bullet/batch/write_step.h"

/// Continuous collision detection stops a body within the step: Bullet then integrates only part of dt.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Whether Bullet may do so in a step of dt. Errs towards true by rounding.
bool may_be_clamped(const btRigidBody& body, btScalar dt);

/// The part of dt by which Bullet has integrated the body: less than 1 where it was stopped.
double turned_fraction(const Batch& batch, std::size_t lane, btScalar dt);

/// Turns the result of a lane by the same part of dt only.
void clamp_step(const Batch& batch, std::size_t lane, const Solved& solved, const StepContext& context,
                StepResult& result);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
