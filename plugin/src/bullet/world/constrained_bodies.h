#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <vector>

#include "bullet/world/multibodies.h"
#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// 1 for a body that the coming solve may constrain: one in an enabled joint, or in a manifold that has contact
/// points and is answered (a trigger's is not). By btCollisionObject::getWorldArrayIndex. If there is no memory
/// for all of the marks, those at the end are missing.
using ConstrainedMarks = std::vector<char>;

void find_constrained_bodies(btDiscreteDynamicsWorld& world, ConstrainedMarks& is_constrained);

/// The same for multibodies, by their number in Multibodies.
void find_constrained_multibodies(const Multibodies& multibodies, ConstrainedMarks& is_constrained);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
