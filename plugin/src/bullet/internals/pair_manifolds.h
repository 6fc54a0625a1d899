#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <cstdint>
#include <vector>

#include "polhode/bullet/precision.h"

/// The manifolds of an overlapping pair. A pair of simple shapes has one. Compound shapes have one for each
/// child near the other body, or for each pair of children; these are created and removed as the bodies move.
namespace polhode {
inline namespace POLHODE_PRECISION {

/// Identifies a manifold of a pair: the indices of the children from the outer shape to the inner one, then
/// the index of the manifold.
using ManifoldPath = std::vector<std::int32_t>;

struct PathedManifold {
  ManifoldPath path;
  btPersistentManifold* manifold;
};

/// Returns the manifolds in the algorithm's order.
std::vector<PathedManifold> manifolds_of(btCollisionAlgorithm& algorithm);

/// Gives the pair an algorithm, if it has none, and exactly the wanted manifolds, as collision detection
/// would at poses at which these children are near. The manifolds' contact points are arbitrary. Omits
/// children that the shapes no longer have.
void make_manifolds(const std::vector<ManifoldPath>& wanted, btBroadphasePair& pair,
                    btCollisionDispatcher& dispatcher, const btDispatcherInfo& info);

/// Deletes the algorithm, as removing the pair would. Does nothing for null.
void drop(btCollisionAlgorithm* algorithm, btCollisionDispatcher& dispatcher);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
