#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <vector>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Marks, by btCollisionObject::getWorldArrayIndex, the objects that the coming solve may constrain: those in
/// an enabled joint, and those in a manifold that has contact points and is answered (a trigger's is not).
void find_constrained_bodies(btDiscreteDynamicsWorld& world, std::vector<char>& is_constrained);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
