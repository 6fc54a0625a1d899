#include "bullet/world/constrained_bodies.h"

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <new>

#include "bullet/internals/prefetch.h"
#include "bullet/internals/private_members.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

void clear(std::size_t size, ConstrainedMarks& marks) {
  marks.clear();
  try {
    marks.reserve(size);
  } catch (const std::bad_alloc&) {
  }
  marks.resize(std::min(size, marks.capacity()), 0);
}

// Ignores bodies without a mark: a joint's partner may stand for the world, or belong to no world.
void mark(int index, ConstrainedMarks& marks) {
  if (index >= 0 && static_cast<std::size_t>(index) < marks.size())
    marks[static_cast<std::size_t>(index)] = 1;
}

// Calls visit(body0, body1) for each manifold that constrains its bodies.
template <class Visit>
void for_contacts(btDispatcher& dispatcher, const Visit& visit) {
  constexpr int kAhead = 8;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    if (i + kAhead < dispatcher.getNumManifolds())
      prefetch(*dispatcher.getManifoldByIndexInternal(i + kAhead));
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    if (manifold.getNumContacts() == 0) continue;
    if (!dispatcher.needsResponse(manifold.getBody0(), manifold.getBody1())) continue;
    visit(*manifold.getBody0(), *manifold.getBody1());
  }
}

}  // namespace

void find_constrained_bodies(btDiscreteDynamicsWorld& world, ConstrainedMarks& is_constrained) {
  clear(static_cast<std::size_t>(world.getNumCollisionObjects()), is_constrained);
  const auto mark_body = [&](const btCollisionObject& body) {
    mark(body.getWorldArrayIndex(), is_constrained);
  };
  for_contacts(*world.getDispatcher(), [&](const btCollisionObject& body0, const btCollisionObject& body1) {
    mark_body(body0);
    mark_body(body1);
  });
  for (int i = 0; i < world.getNumConstraints(); ++i) {
    const btTypedConstraint& joint = *world.getConstraint(i);
    if (!joint.isEnabled()) continue;
    mark_body(joint.getRigidBodyA());
    mark_body(joint.getRigidBodyB());
  }
  auto* const with_multibodies = dynamic_cast<btMultiBodyDynamicsWorld*>(&world);
  for (int i = 0; with_multibodies != nullptr && i < with_multibodies->getNumMultiBodyConstraints(); ++i) {
    for (const btRigidBody* body : rigid_bodies_of(*with_multibodies->getMultiBodyConstraint(i))) {
      if (body != nullptr) mark_body(*body);
    }
  }
}

void find_constrained_multibodies(const Multibodies& multibodies, ConstrainedMarks& is_constrained) {
  btMultiBodyDynamicsWorld& world = *multibodies.world();
  clear(multibodies.size(), is_constrained);
  const auto mark_multibody = [&](const btMultiBody* multibody) {
    if (multibody != nullptr) mark(multibodies.index_of(*multibody), is_constrained);
  };
  const auto mark_if_link = [&](const btCollisionObject& object) {
    const btMultiBodyLinkCollider* collider = btMultiBodyLinkCollider::upcast(&object);
    if (collider != nullptr) mark_multibody(collider->m_multiBody);
  };
  for_contacts(*world.getDispatcher(), [&](const btCollisionObject& body0, const btCollisionObject& body1) {
    mark_if_link(body0);
    mark_if_link(body1);
  });
  for (int i = 0; i < world.getNumMultiBodyConstraints(); ++i) {
    mark_multibody(world.getMultiBodyConstraint(i)->getMultiBodyA());
    mark_multibody(world.getMultiBodyConstraint(i)->getMultiBodyB());
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
