#pragma once

#include "bullet/batch/batch.h"

/// External changes: what somebody other than the library did to a managed body since the library last wrote
/// it. This is the list of what counts as one, and how each is adopted.
///
///   pose        teleport: the basis is not q_WB rounded; also the solver's split impulse
///   velocity    kick: the angular velocity is not the one written
///   inertia     setMassProps: the velocity stays, the momentum follows
///   damping     Bullet's, before the solve: state and written velocity are scaled by its factor
///   non-finite  a NaN or infinity: non_finite.h
///
/// A body without one goes on from its double state: so a single-precision world turns with double accuracy.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Rounds a number as Bullet holds it.
inline double rounded_to_bullet(double number) {
  return static_cast<double>(static_cast<btScalar>(number));
}
POLHODE_INLINE Wide rounded_to_bullet(const Wide& number) {
  return Wide::converted(BulletWide::converted(number));
}

/// The state's velocity after a kick from the written velocity to the one found, for Real = double or Wide. A
/// free body's is the one found, so that pose and velocity set anew leave nothing of what was. A constrained
/// body's momentum runs half a step beside I v: that stays. It is quadratic in the velocity, so a body set to
/// rest rests.
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

/// Moments in kg m^2; 0 where the body does not turn about the axis, as in btRigidBody::getLocalInertia.
Vector3 moments_B(const btVector3& inverse_inertia_B);

/// Sets L from omega: by one formula everywhere, so that two histories of one state give the same bits.
void make_momentum_agree(const Vector3& inertia_B, bool keeps_rotation, RotationState& state);

/// Brings `state`, that of the lane, in line with what the body says now. Returns false if nothing was
/// changed.
bool adopt_external_changes(const Batch& batch, std::size_t lane, RotationState& state);

/// The same for the batch itself.
void adopt_external_changes(Batch& batch, std::size_t lane);

/// Turns the state by a rotation that came from outside. The velocity stays.
void adopt_external_rotation(const Quaternion& turn_B, const Vector3& inertia_B, bool keeps_rotation,
                             RotationState& state);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
