#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

/// The stages of a batch of multibody proxies (MultibodyProxy): those of stages.h, between reading and
/// writing the multibodies.
namespace polhode {
inline namespace POLHODE_PRECISION {

void prefetch_multibodies(const Batch& batch);

/// Gives the solver the velocities that the scheme wants. Call right before the solve.
void before_solve_of_multibodies(Batch& batch, const StepContext& context) noexcept;

/// Takes the step and overwrites Bullet's result. Call after Bullet has integrated the multibodies.
void after_integration_of_multibodies(Batch& batch, const StepContext& context) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
