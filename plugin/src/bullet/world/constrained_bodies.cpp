#include "bullet/world/constrained_bodies.h"

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// A joint's partner may stand for the world, or belong to no world.
void mark(const btCollisionObject& object, std::vector<char>& is_constrained) {
  const auto index = static_cast<std::size_t>(object.getWorldArrayIndex());
  if (object.getWorldArrayIndex() >= 0 && index < is_constrained.size()) is_constrained[index] = 1;
}

}  // namespace

void find_constrained_bodies(btDiscreteDynamicsWorld& world, std::vector<char>& is_constrained) {
  is_constrained.assign(static_cast<std::size_t>(world.getNumCollisionObjects()), 0);
  btDispatcher& dispatcher = *world.getDispatcher();
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    if (manifold.getNumContacts() == 0) continue;
    if (!dispatcher.needsResponse(manifold.getBody0(), manifold.getBody1())) continue;
    mark(*manifold.getBody0(), is_constrained);
    mark(*manifold.getBody1(), is_constrained);
  }
  for (int i = 0; i < world.getNumConstraints(); ++i) {
    const btTypedConstraint& joint = *world.getConstraint(i);
    if (!joint.isEnabled()) continue;
    mark(joint.getRigidBodyA(), is_constrained);
    mark(joint.getRigidBodyB(), is_constrained);
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
