#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// A number that no other body constructed in this process has. Applications delete bodies without telling us
/// and the allocator hands the address to the next one; address and identity together never name two bodies.
int body_identity(const btRigidBody& body);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
