#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

/// Bodies that may not turn about some axis, one by one: an angular factor of 0 locks an axis of the world,
/// an inverse inertia of 0 one of the body.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Lanes whose body may not turn about some axis at all.
POLHODE_INLINE BulletMask are_held(const BulletRows& inverse_inertia_B, const BulletRows& angular_factor) {
  const BulletRows& I = inverse_inertia_B;
  const BulletRows& f = angular_factor;
  const btScalar zero = 0;
  return (I.x == zero) | (I.y == zero) | (I.z == zero) | (f.x == zero) | (f.y == zero) | (f.z == zero);
}

/// Returns a velocity without its components about the locked world axes (factor 0), which torques take out:
/// v - W P (P^T W P)^-1 P^T v, P the locked axes, W the inverse inertia (Gauss' principle). The locked
/// components are 0.
Vector3 project_onto_unlocked_axes(const Matrix3& inverse_inertia_W, const Vector3& angular_factor,
                                   const Vector3& v_W);

/// Before the solve: gives the solver the turn velocity without what the lock forbids. About a locked axis
/// the body goes on as it turns there, which is not at all unless the application has set it. The batch has its
/// held_turns.
void give_held(Batch& batch, std::size_t lane, const StepContext& context);

/// After the solve: the state at the end of a step of dt. `solved_W` is the solver's velocity on entry, the
/// velocity of the turn on return.
RotationState step_held(const Batch& batch, std::size_t lane, const StepContext& context, Vector3& solved_W);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
