#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// The values of Bullet's bodies after the solve.
struct Solved {
  BulletRows omega_W;        ///< the solver's velocity; if Bullet integrated, the one it integrated with
  BulletRows shown_later_W;  ///< the body's present velocity
  BulletRows linear_velocity;
  BulletRows origin;  ///< at the end of the step
  LaneBits acted;     ///< omega_W differs from the velocity given to the solver
  LaneBits turned;    ///< the pose differs from the one written, or may differ because Bullet integrated it
  LaneBits finite;
};

/// The end of the step, before it is written.
struct StepResult {
  WideState state;
  Vector3Wide shown_W;       ///< the velocity to write to the body
  Vector3Wide mean_W;        ///< mean velocity of the turn, by which Bullet interpolates motion states
  LaneBits turns_by_solved;  ///< lanes that turn by the solver's velocity
};

/// Writes the result of the lanes to the batch and to Bullet's bodies: pose, velocities, and inverse inertia
/// in world axes. Discards a result beyond the limits of rotation_limits.h: the body has diverged, keeps its
/// last orientation and stops.
void write_step(Batch& batch, const LaneBits& lanes, PoseIntegratedBy integrator, const Solved& solved,
                const StepResult& result, const StepContext& context);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
