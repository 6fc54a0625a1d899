#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>

#include "polhode/rotation_math.h"
#include "world/conversions.h"

/// Reads the rotation of a body in a plain Bullet world, in double precision.
namespace polhode::demos {

/// Returns the moments of inertia as rounded by Bullet, which stores their inverses.
inline Vector3 inertia_of(const btRigidBody& body) {
  return from_bullet(body.getInvInertiaDiagLocal()).cwiseInverse();
}

inline RotationState rotation_of(const btRigidBody& body) {
  RotationState state;
  state.R_WB = from_bullet(body.getWorldTransform().getBasis());
  state.q_WB = Quaternion(state.R_WB).normalized();
  set_omega(state, inertia_of(body), from_bullet(body.getAngularVelocity()));
  return state;
}

inline Vector3 inertia_of(const btMultiBody& multibody) {
  return from_bullet(multibody.getBaseInertia());
}

/// Returns the rotation of a multibody, which stores the quaternion from world to body and no basis.
inline RotationState rotation_of(const btMultiBody& multibody) {
  RotationState state;
  set_orientation(state, from_bullet(multibody.getWorldToBaseRot().inverse()).normalized());
  set_omega(state, inertia_of(multibody), from_bullet(multibody.getBaseOmega()));
  return state;
}

}  // namespace polhode::demos
