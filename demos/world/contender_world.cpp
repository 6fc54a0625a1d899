#include "world/contender_world.h"

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>

#include <utility>

#include "polhode/bullet/rotation_world.h"

namespace polhode::demos {

namespace {

// Few bodies touch at once, and Bullet's default size, 4096, makes a world slow to set up. Bullet allocates
// more if a pool is full.
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
    auto& world = make_world<RotationWorld<btDiscreteDynamicsWorld>, btSequentialImpulseConstraintSolver>();
    world.rotation().set_default_scheme(*scheme);
    rotation_ = &world.rotation();
  } else if (std::holds_alternative<BulletMultibody>(method_)) {
    multibody_world_ = &make_world<btMultiBodyDynamicsWorld, btMultiBodyConstraintSolver>();
  } else {
    make_world<btDiscreteDynamicsWorld, btSequentialImpulseConstraintSolver>();
  }
}

template <class World, class Solver>
World& ContenderWorld::make_world() {
  auto solver = std::make_unique<Solver>();
  auto world = std::make_unique<World>(&dispatcher_, &broadphase_, solver.get(), &configuration_);
  World& made = *world;
  solver_ = std::move(solver);
  world_ = std::move(world);
  return made;
}

void ContenderWorld::set_gyroscopic_flag(btRigidBody& body) const {
  if (const BulletMode* mode = std::get_if<BulletMode>(&method_)) body.setFlags(bullet_flags(*mode));
}

}  // namespace polhode::demos
