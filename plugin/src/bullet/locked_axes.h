#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bullet/conversions.h"
#include "polhode/bullet/precision.h"
#include "polhode/rotation_scheme.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// An inverse inertia of 0 on an axis means "does not turn about it": an infinite moment. A body that has one
/// has no gyroscopic change, since with omega 0 about that axis omega x I omega acts about it alone.
inline bool has_unturnable_axis(const btRigidBody& body) {
  const btVector3& inverse = body.getInvInertiaDiagLocal();
  return inverse.x() == 0 || inverse.y() == 0 || inverse.z() == 0;
}

/// An angular factor below 1 in some world axis holds the body back there.
inline bool has_locked_axis(const btRigidBody& body) {
  return !same(body.getAngularFactor(), btVector3(1, 1, 1));
}

/// Takes what a locked axis forbids out of the step from `start` to `end`: of the scheme's change of velocity
/// the part that the locking torques leave (locked_change_W), and the orientation turned by that velocity
/// instead.
void hold_locked_axes(const btRigidBody& body, const StepInput& input, const RotationState& start,
                      RotationState& end);

/// The change of omega_W that remains of a free change when torques about the locked world axes (factor 0)
/// hold those components at zero: change - I_W^-1 P (P^T I_W^-1 P)^-1 P^T change, P the locked axes (Gauss'
/// principle). Factors between 0 and 1 scale their component, as Bullet scales an impulse's.
Vector3 locked_change_W(const Matrix3& inverse_inertia_W, const Vector3& angular_factor,
                        const Vector3& free_change_W);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
