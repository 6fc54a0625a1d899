#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <cstdint>
#include <vector>

#include "polhode/bullet/precision.h"

/// The manifolds of an overlapping pair. A pair of simple shapes has one; compound shapes have one for each
/// child that is near the other body, or each pair of children, and make and drop them as the bodies move.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Which one of a pair's: the children's numbers from the outer shape to the inner one, then that of the
/// manifold.
using ManifoldPath = std::vector<std::int32_t>;

struct PathedManifold {
  ManifoldPath path;
  btPersistentManifold* manifold;
};

/// In the order in which the algorithm has them.
std::vector<PathedManifold> manifolds_of(btCollisionAlgorithm& algorithm);

/// Gives the pair an algorithm, if it has none, and exactly these manifolds, with whatever points, as
/// collision detection would at poses where these children are near. Children that the shapes no longer have
/// are left out.
void make_manifolds(const std::vector<ManifoldPath>& wanted, btBroadphasePair& pair,
                    btCollisionDispatcher& dispatcher, const btDispatcherInfo& info);

/// Does what removing the pair would do with it. Null: nothing.
void drop(btCollisionAlgorithm* algorithm, btCollisionDispatcher& dispatcher);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
