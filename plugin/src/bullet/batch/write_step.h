#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Bullet's bodies after the solve.
struct Solved {
  BulletRows omega_W;        ///< the solver's; where Bullet integrated, what it integrated with
  BulletRows shown_later_W;  ///< what the body shows now
  BulletRows linear_velocity;
  BulletRows origin;  ///< at the end of the step
  LaneBits acted;     ///< omega_W is not what the solver was given
  LaneBits turned;    ///< the pose is not the one written, or unknown because Bullet has integrated it
  LaneBits finite;
};

/// The end of the step, before it is written.
struct StepResult {
  WideState state;
  Vector3Wide shown_W;       ///< the velocity that the body is to show
  Vector3Wide mean_W;        ///< of the turn: by this Bullet interpolates motion states
  LaneBits turns_by_solved;  ///< lanes that turned by the solver's velocity
};

/// Writes the result of the lanes to the batch and to Bullet's bodies: the pose, the velocities, and the
/// inverse inertia in the world. A result past the limits of rotation_limits.h is not written: the body has
/// diverged, keeps its last orientation and stops.
void write_step(Batch& batch, const LaneBits& lanes, PoseIntegratedBy integrator, const Solved& solved,
                const StepResult& result, const StepContext& context);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
