#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Computes Bullet's own result by calling the linked Bullet: the same code compiled here could round
/// differently. Constructing a btRigidBody counts up a global number, so make one where no other thread makes
/// a body.
class BulletTurn {
 public:
  BulletTurn();

  /// The basis after Bullet's turn by omega_W (rad/s) over dt (s).
  btMatrix3x3 turned(const btMatrix3x3& basis, const btVector3& omega_W, btScalar dt);

  /// The factor by which Bullet's damping multiplies an angular velocity in dt (s); angular_damping as in
  /// btRigidBody::setDamping.
  btScalar damping_factor(btScalar angular_damping, btScalar dt);

  /// A body of no world: stands in for lanes without one, to be read and written at will.
  btRigidBody& placeholder() { return placeholder_; }

 private:
  btRigidBody body_;
  btRigidBody placeholder_;
  // Bullet takes a power for the factor; most bodies of a world have the same.
  btScalar damping_ = 0;
  btScalar damped_dt_ = 0;
  btScalar damping_factor_ = 1;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
