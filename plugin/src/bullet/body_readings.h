#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cmath>

#include "bullet/conversions.h"
#include "bullet/locked_axes.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Moments in kg m^2; 0 where the body does not turn about the axis, as in btRigidBody::getLocalInertia.
inline Vector3 inertia_B(const btRigidBody& body) {
  const Vector3 moments = to_double(body.getInvInertiaDiagLocal()).cwiseInverse();
  if (!has_unturnable_axis(body)) return moments;
  return moments.unaryExpr([](double moment) { return std::isinf(moment) ? 0.0 : moment; });
}

/// Bullet is given a rotation, of a body that swells too: it keeps contact points in the body's frame and
/// gets there by a transpose, so that with a swollen basis it would lose them at once.
inline btMatrix3x3 basis_of(const Quaternion& q_WB) {
  return to_bullet(Matrix3(q_WB.toRotationMatrix()));
}

/// Whether Bullet's solver and integration move and turn the body at present.
inline bool turns_by_solver(const btRigidBody& body) {
  return body.isActive() && !body.isStaticOrKinematicObject();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
