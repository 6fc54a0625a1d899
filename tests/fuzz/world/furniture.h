#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletSoftBody/btSoftBody.h>
#include <btBulletCollisionCommon.h>

#include <memory>

/// Things for rigid bodies to touch that are no rigid bodies. They outlive their world.
namespace polhode::fuzz {

/// Hangs between two points at a height of 1.
struct Rope {
  template <class World>
  void hang(World& world) {
    make(world.getWorldInfo());
    world.addSoftBody(body.get());
  }
  void make(btSoftBodyWorldInfo& info);

  std::unique_ptr<btSoftBody> body;
};

/// A ball on an arm, which a btMultiBody turns about an axis at a height of 2.
struct Pendulum {
  void hang(btMultiBodyDynamicsWorld& world);

  btSphereShape ball{btScalar(0.5)};
  std::unique_ptr<btMultiBody> body;
  std::unique_ptr<btMultiBodyLinkCollider> collider;
};

}  // namespace polhode::fuzz
