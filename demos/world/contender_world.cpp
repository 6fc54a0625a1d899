#include "world/contender_world.h"

#include <utility>

#include "polhode/bullet/rotation_world.h"

namespace polhode::demos {

namespace {

// Few bodies touch at once. Bullet's own size, 4096, makes a world slow to set up; where a pool is used up,
// Bullet allocates.
btDefaultCollisionConstructionInfo small_pools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 64;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 64;
  return info;
}

int bullet_flags(BulletMode mode) {
  switch (mode) {
    case BulletMode::explicit_force:
      return BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT;
    case BulletMode::implicit_world:
      return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD;
    case BulletMode::implicit_body:
      return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;
    case BulletMode::none:
      break;
  }
  return 0;
}

}  // namespace

ContenderWorld::ContenderWorld(const Contender& contender)
    : method_(contender.method), configuration_(small_pools()) {
  if (const SchemePointer* scheme = std::get_if<SchemePointer>(&method_)) {
    auto world = std::make_unique<RotationWorld<btDiscreteDynamicsWorld>>(&dispatcher_, &broadphase_,
                                                                          &solver_, &configuration_);
    world->rotation().set_default_scheme(*scheme);
    rotation_ = &world->rotation();
    world_ = std::move(world);
  } else {
    world_ = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_);
  }
}

void ContenderWorld::set_gyroscopic_flag(btRigidBody& body) const {
  if (const BulletMode* mode = std::get_if<BulletMode>(&method_)) body.setFlags(bullet_flags(*mode));
}

}  // namespace polhode::demos
