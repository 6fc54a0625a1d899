#include "fuzz/world/furniture.h"

#include <BulletSoftBody/btSoftBodyHelpers.h>

namespace polhode::fuzz {

void Rope::make(btSoftBodyWorldInfo& info) {
  constexpr int kNodesBetween = 6;
  constexpr int kBothEndsFixed = 3;
  info.m_sparsesdf.Initialize();
  body.reset(btSoftBodyHelpers::CreateRope(info, btVector3(-2, 0, 1), btVector3(2, 0, 1), kNodesBetween,
                                           kBothEndsFixed));
}

void Pendulum::hang(btMultiBodyDynamicsWorld& world) {
  const btVector3 arm(0, 0, -1);
  body = std::make_unique<btMultiBody>(1, btScalar(1), btVector3(1, 1, 1), true, false);
  body->setBaseWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 2)));
  body->setupRevolute(0, 1, btVector3(1, 1, 1), -1, btQuaternion::getIdentity(), btVector3(0, 1, 0),
                      btVector3(0, 0, 0), arm, true);
  body->finalizeMultiDof();
  world.addMultiBody(body.get());
  collider = std::make_unique<btMultiBodyLinkCollider>(body.get(), 0);
  collider->setCollisionShape(&ball);
  collider->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 1)));
  world.addCollisionObject(collider.get());
  body->getLink(0).m_collider = collider.get();
}

}  // namespace polhode::fuzz
