#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <cstdint>
#include <vector>

#include "multithreading/digest.h"
#include "polhode/bullet/rotation_control.h"

namespace polhode::testing {

/// Returns a hash of every bit of a world's visible state: bodies, their rotation, contact points with their
/// impulses, and the order of the manifolds and pairs.
inline std::uint64_t digest_of(btDiscreteDynamicsWorld& world, const RotationControl& rotation) {
  Digest digest;
  for (int i = 0; i < world.getNumCollisionObjects(); ++i) {
    const btRigidBody* const body = btRigidBody::upcast(world.getCollisionObjectArray()[i]);
    if (body == nullptr) continue;
    digest.add(*body);
    digest.add(static_cast<double>(body->getDeactivationTime()));
    if (rotation.manages(*body)) digest.add(rotation.rotation_of(*body));
  }
  btDispatcher& dispatcher = *world.getDispatcher();
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    digest.add(static_cast<std::uint64_t>(manifold.getBody0()->getWorldArrayIndex()));
    digest.add(static_cast<std::uint64_t>(manifold.getBody1()->getWorldArrayIndex()));
    for (int point = 0; point < manifold.getNumContacts(); ++point)
      digest.add(static_cast<double>(manifold.getContactPoint(point).m_appliedImpulse));
  }
  const btBroadphasePairArray& pairs = world.getPairCache()->getOverlappingPairArray();
  for (int i = 0; i < pairs.size(); ++i) {
    digest.add(static_cast<std::uint64_t>(pairs[i].m_pProxy0->m_uniqueId));
    digest.add(static_cast<std::uint64_t>(pairs[i].m_pProxy1->m_uniqueId));
  }
  for (int i = 0; i < world.getNumConstraints(); ++i)
    digest.add(static_cast<double>(world.getConstraint(i)->internalGetAppliedImpulse()));
  return digest.value();
}

/// Returns the digest after each step.
template <class Way>
std::vector<std::uint64_t> run(Way& way, int steps, btScalar dt) {
  std::vector<std::uint64_t> digests;
  for (int step = 0; step < steps; ++step) {
    way.step(dt);
    digests.push_back(digest_of(way.world(), way.rotation()));
  }
  return digests;
}

/// Returns the first step after which two runs differ, counted from 1; 0 if there is none.
inline int first_difference(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    if (a[i] != b[i]) return static_cast<int>(i) + 1;
  }
  return 0;
}

}  // namespace polhode::testing
