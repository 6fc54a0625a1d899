#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletSoftBody/btSoftBody.h>
#include <btBulletCollisionCommon.h>

#include <memory>

/// Objects other than rigid bodies that rigid bodies can touch. They outlive their world.
namespace polhode::fuzz {

/// A rope that hangs between two points at height 1.
struct Rope {
  template <class World>
  void hang(World& world) {
    make(world.getWorldInfo());
    world.addSoftBody(body.get());
  }
  void make(btSoftBodyWorldInfo& info);

  std::unique_ptr<btSoftBody> body;
};

/// A ball on an arm, a btMultiBody that turns about an axis at height 2.
struct Pendulum {
  void hang(btMultiBodyDynamicsWorld& world);

  btSphereShape ball{btScalar(0.5)};
  std::unique_ptr<btMultiBody> body;
  std::unique_ptr<btMultiBodyLinkCollider> collider;
};

}  // namespace polhode::fuzz
