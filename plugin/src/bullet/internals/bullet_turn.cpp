#include "bullet/internals/bullet_turn.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

btRigidBody any_body() {
  return {btScalar(1.0), nullptr, nullptr, btVector3(1.0, 1.0, 1.0)};
}

}  // namespace

BulletTurn::BulletTurn() : body_(any_body()), placeholder_(any_body()) {}

btMatrix3x3 BulletTurn::turned(const btMatrix3x3& basis, const btVector3& omega_W, btScalar dt) {
  body_.setWorldTransform(btTransform(basis));
  body_.setAngularVelocity(omega_W);
  btTransform result;
  body_.predictIntegratedTransform(dt, result);
  return result.getBasis();
}

btScalar BulletTurn::damping_factor(btScalar angular_damping, btScalar dt) {
  if (angular_damping == btScalar(0.0)) return btScalar(1.0);
  if (angular_damping != damping_ || dt != damped_dt_) {
    damping_ = angular_damping;
    damped_dt_ = dt;
    body_.setDamping(btScalar(0.0), angular_damping);
    body_.setAngularVelocity(btVector3(1, 1, 1));
    body_.applyDamping(dt);
    damping_factor_ = body_.getAngularVelocity().x();
  }
  return damping_factor_;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
