#pragma once

#include "bullet/batch/batch.h"
#include "bullet/batch/step_context.h"

/// Steps bodies with locked axes, one by one. An angular factor of 0 locks a world axis, an inverse inertia
/// of 0 locks a body axis.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Returns the lanes whose body has a locked axis.
POLHODE_INLINE BulletMask are_held(const BulletRows& inverse_inertia_B, const BulletRows& angular_factor) {
  const BulletRows& I = inverse_inertia_B;
  const BulletRows& f = angular_factor;
  const btScalar zero = 0;
  return (I.x == zero) | (I.y == zero) | (I.z == zero) | (f.x == zero) | (f.y == zero) | (f.z == zero);
}

/// Removes the velocity about locked world axes (factor 0) by the reaction torques about these axes. Returns
/// v - W P (P^T W P)^-1 P^T v, P the locked axes, W the inverse inertia (Gauss' principle). The locked
/// components of the result are 0.
Vector3 project_onto_unlocked_axes(const Matrix3& inverse_inertia_W, const Vector3& angular_factor,
                                   const Vector3& v_W);

/// Gives the solver the turn velocity, projected onto the free axes. About a locked axis the body keeps its
/// rotation, which is 0 unless the application has set it. Call before the solve. Requires batch.held_turns.
void give_held(Batch& batch, std::size_t lane, const StepContext& context);

/// Returns the state at the end of a step of dt. Call after the solve. `solved_W` is the solver's velocity on
/// entry, the velocity of the turn on return.
RotationState step_held(const Batch& batch, std::size_t lane, const StepContext& context, Vector3& solved_W);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
