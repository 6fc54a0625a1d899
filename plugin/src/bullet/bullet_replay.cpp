#include "bullet/bullet_replay.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

BulletReplay::BulletReplay() : body_(btScalar(1.0), nullptr, nullptr, btVector3(1.0, 1.0, 1.0)) {}

btMatrix3x3 BulletReplay::turned(const btMatrix3x3& basis, const btVector3& omega_W, btScalar dt) {
  body_.setWorldTransform(btTransform(basis));
  body_.setAngularVelocity(omega_W);
  btTransform result;
  body_.predictIntegratedTransform(dt, result);
  return result.getBasis();
}

btVector3 BulletReplay::damped(const btVector3& omega_W, btScalar angular_damping, btScalar dt) {
  if (angular_damping == btScalar(0.0)) return omega_W;
  if (angular_damping != damping_ || dt != damped_dt_) {
    damping_ = angular_damping;
    damped_dt_ = dt;
    body_.setDamping(btScalar(0.0), angular_damping);
    body_.setAngularVelocity(btVector3(1, 1, 1));
    body_.applyDamping(dt);
    damping_factor_ = body_.getAngularVelocity().x();
  }
  return omega_W * damping_factor_;
}

btMatrix3x3 BulletReplay::inverse_inertia_tensor_W(const btMatrix3x3& basis,
                                                   const btVector3& inverse_inertia_B) {
  body_.setWorldTransform(btTransform(basis));
  body_.setInvInertiaDiagLocal(inverse_inertia_B);
  body_.updateInertiaTensor();
  return body_.getInvInertiaTensorWorld();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
