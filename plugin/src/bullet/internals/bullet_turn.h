#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Computes Bullet's own result by calling the linked Bullet: the same code compiled here could round
/// differently. The constructor creates a btRigidBody, which increments a global counter; do not run it while
/// another thread creates a body.
class BulletTurn {
 public:
  BulletTurn();

  /// Returns the basis after Bullet's turn by omega_W (rad/s) over dt (s).
  btMatrix3x3 turned(const btMatrix3x3& basis, const btVector3& omega_W, btScalar dt);

  /// Returns the factor by which Bullet's damping multiplies an angular velocity in dt (s). angular_damping
  /// is the argument of btRigidBody::setDamping.
  btScalar damping_factor(btScalar angular_damping, btScalar dt);

  /// Returns a body outside any world, which lanes without a body may read and write.
  btRigidBody& placeholder() { return placeholder_; }

 private:
  btRigidBody body_;
  btRigidBody placeholder_;
  // Cached, since Bullet computes a power, and most bodies of a world have the same damping.
  btScalar damping_ = 0;
  btScalar damped_dt_ = 0;
  btScalar damping_factor_ = 1;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
