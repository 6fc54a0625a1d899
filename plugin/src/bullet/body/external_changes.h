#pragma once

#include "bullet/batch/batch.h"

/// External changes: changes of a body by the application or by Bullet since the library last wrote the body.
/// This is the list of external changes and how each is adopted:
///
///   pose        teleport: the basis is not q_WB rounded; also the solver's split impulse
///   velocity    kick: the angular velocity is not the one written
///   inertia     setMassProps: the velocity stays, the momentum follows
///   damping     Bullet's, before the solve: state and written velocity are scaled by its factor
///   non-finite  a NaN or infinity: non_finite.h
///
/// A body without external changes continues from its double-precision state, so that it turns with double
/// accuracy even in a single-precision world.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Rounds a number to Bullet's precision.
inline double rounded_to_bullet(double number) {
  return static_cast<double>(static_cast<btScalar>(number));
}
POLHODE_INLINE Wide rounded_to_bullet(const Wide& number) {
  return Wide::converted(BulletWide::converted(number));
}

/// Returns the state's velocity after a kick from the written velocity to the one found. Real is double or
/// Wide. A free body gets the velocity found, so that a new pose and velocity leave nothing of the old
/// motion. The velocity of a constrained body differs from the written one by half a step, and keeps this
/// difference. The difference is quadratic in the velocity and is scaled accordingly, so that a body set to
/// rest is at rest.
template <class Vector>
Vector velocity_after_kick(const Vector& found_W, const Vector& written_W, const Vector& state_W) {
  using polhode::select;
  using Real = typename Vector::Scalar;
  Vector beside_W = state_W - written_W;
  for (int i = 0; i < 3; ++i) {
    beside_W[i] = select(rounded_to_bullet(state_W[i]) == written_W[i], Real(0.0), beside_W[i]);
  }
  const Real found2 = found_W.squaredNorm();
  const Real written2 = written_W.squaredNorm();
  const Real kept = select(found2 < written2, Real(found2 / written2), Real(1.0));
  return found_W + kept * beside_W;
}

/// Returns moments in kg m^2; 0 for an axis without inverse inertia, as in btRigidBody::getLocalInertia.
Vector3 moments_B(const btVector3& inverse_inertia_B);

/// Sets L_W to match omega_W. Uses one formula everywhere, so that equal states have equal bits.
void make_momentum_agree(const Vector3& inertia_B, bool keeps_rotation, RotationState& state);

/// Updates `state`, the state of the lane, to match the body. Returns false if there was no external change.
bool adopt_external_changes(const Batch& batch, std::size_t lane, RotationState& state);

/// Updates the lane in the batch itself.
void adopt_external_changes(Batch& batch, std::size_t lane);

/// Rotates the state by an external rotation and keeps the velocity.
void adopt_external_rotation(const Quaternion& turn_B, const Vector3& inertia_B, bool keeps_rotation,
                             RotationState& state);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
