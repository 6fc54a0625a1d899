#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

/// The stages of a batch whose bodies are the proxies of multibodies (MultibodyProxy): those of stages.h, between
/// reading the multibodies and writing them.
namespace polhode {
inline namespace POLHODE_PRECISION {

void prefetch_multibodies(const Batch& batch);

/// Right before the solver, which then starts from the velocities that the batch wants.
void before_solve_of_multibodies(Batch& batch, const StepContext& context) noexcept;

/// When Bullet has integrated the multibodies: takes the step and writes it over Bullet's.
void after_integration_of_multibodies(Batch& batch, const StepContext& context) noexcept;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
