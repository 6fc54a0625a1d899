#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Answers what Bullet itself made, or would make, of a body in a step: by Bullet's own compiled code, since
/// the same lines compiled here with other flags would differ in the last bit.
class BulletReplay {
 public:
  BulletReplay();

  /// The basis after Bullet's turn by omega_W (rad/s) over dt (s).
  btMatrix3x3 turned(const btMatrix3x3& basis, const btVector3& omega_W, btScalar dt);

  /// The angular velocity after Bullet's damping over dt (s), angular_damping as in btRigidBody::setDamping.
  /// The thresholds of m_additionalDamping are not readable; what they take off counts as the solver's
  /// change.
  btVector3 damped(const btVector3& omega_W, btScalar angular_damping, btScalar dt);

  /// The world's inverse inertia tensor of a body with that basis.
  btMatrix3x3 inverse_inertia_tensor_W(const btMatrix3x3& basis, const btVector3& inverse_inertia_B);

 private:
  btRigidBody body_;
  // Bullet takes a power for the factor; most bodies of a world have the same.
  btScalar damping_ = 0;
  btScalar damped_dt_ = 0;
  btScalar damping_factor_ = 1;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
