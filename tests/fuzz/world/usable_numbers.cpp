#include "fuzz/world/usable_numbers.h"

#include <cmath>

namespace polhode::fuzz {

bool is_finite(const btVector3& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool is_finite(const btMatrix3x3& m) {
  return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]);
}

bool is_finite(const btRigidBody& body) {
  return is_finite(body.getWorldTransform().getBasis()) && is_finite(body.getWorldTransform().getOrigin()) &&
         is_finite(body.getLinearVelocity()) && is_finite(body.getAngularVelocity()) &&
         is_finite(body.getInvInertiaTensorWorld());
}

bool is_finite(const btMultiBody& multibody) {
  const btQuaternion& q = multibody.getWorldToBaseRot();
  return is_finite(btVector3(q.x(), q.y(), q.z())) && std::isfinite(q.w()) &&
         is_finite(multibody.getBasePos()) && is_finite(multibody.getBaseVel()) &&
         is_finite(multibody.getBaseOmega());
}

btScalar inertia(btScalar x, bool zero_is_allowed) {
  const btScalar size = std::abs(x);
  if (size == 0 && zero_is_allowed) return 0;
  return std::isfinite(size) && std::isnormal(1 / size) ? size : btScalar(1);
}

btVector3 moments(const btVector3& v) {
  return {inertia(v.x(), true), inertia(v.y(), true), inertia(v.z(), true)};
}

btQuaternion orientation(const btVector3& v, btScalar x) {
  const btQuaternion q(v.x(), v.y(), v.z(), x);
  const btScalar length2 = q.length2();
  const bool is_usable = std::isfinite(length2) && length2 > btScalar(1e-6);
  return is_usable ? q.normalized() : btQuaternion::getIdentity();
}

}  // namespace polhode::fuzz
