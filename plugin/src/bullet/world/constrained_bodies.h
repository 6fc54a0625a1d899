#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <vector>

#include "bullet/world/multibodies.h"
#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Marks the bodies that the coming solve may constrain, by btCollisionObject::getWorldArrayIndex: 1 for a
/// body in an enabled joint, or in a manifold with contact points and a contact response (a trigger has
/// none). If memory runs out, the last marks are missing.
using ConstrainedMarks = std::vector<char>;

void find_constrained_bodies(btDiscreteDynamicsWorld& world, ConstrainedMarks& is_constrained);

/// Does the same for multibodies, by their index in Multibodies.
void find_constrained_multibodies(const Multibodies& multibodies, ConstrainedMarks& is_constrained);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
