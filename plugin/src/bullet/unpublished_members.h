#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "polhode/bullet/precision.h"

/// What Bullet keeps of a body without an accessor.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// A number that no other btRigidBody of this process has: tells a body from one that was deleted and had the
/// same address.
int body_identity(const btRigidBody& body);

/// btRigidBodyConstructionInfo::m_additionalDamping, which damps a slow body also at a damping of 0.
bool has_additional_damping(const btRigidBody& body);

/// What btRigidBody::updateInertiaTensor sets.
btMatrix3x3& inverse_inertia_tensor_W(btRigidBody& body);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
