#include "fuzz/world/world.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <BulletSoftBody/btSoftMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include "polhode/bullet/rotation_world.h"
#include "support/scene.h"

namespace polhode::fuzz {

namespace {

btDefaultCollisionConstructionInfo small_pools() {
  constexpr int kPool = 64;
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = kPool;
  info.m_defaultMaxCollisionAlgorithmPoolSize = kPool;
  return info;
}

// Gives access to protected members of Bullet's classes.
struct Times : btDiscreteDynamicsWorld {
  static constexpr auto kLocal = &Times::m_localTime;
  static constexpr auto kFixedStep = &Times::m_fixedTimeStep;
};

}  // namespace

template <class Base>
void World::make(Way way) {
  if (solver == nullptr) solver = testing::make_solver<Base>();
  if (way == Way::rotation_world) {
    auto made =
        testing::make_world<RotationWorld<Base>>(&dispatcher, &broadphase, solver.get(), &configuration);
    rotation = &made->rotation();
    world = std::move(made);
  } else {
    world = testing::make_world<Base>(&dispatcher, &broadphase, solver.get(), &configuration);
  }
  if (way == Way::plugin) {
    plugin = std::make_unique<RotationPlugin>(*world);
    rotation = &plugin->rotation();
  }
}

World::World(Way way, WorldKind kind, std::function<void()> act)
    : configuration(small_pools()), action(std::move(act)) {
  switch (kind) {
    case WorldKind::soft_rigid:
      make<btSoftRigidDynamicsWorld>(way);
      rope.hang(static_cast<btSoftRigidDynamicsWorld&>(*world));
      break;
    case WorldKind::multi_body:
      make<btMultiBodyDynamicsWorld>(way);
      pendulum.hang(static_cast<btMultiBodyDynamicsWorld&>(*world));
      break;
    case WorldKind::soft_multi_body: {
      make<btSoftMultiBodyDynamicsWorld>(way);
      auto& made = static_cast<btSoftMultiBodyDynamicsWorld&>(*world);
      rope.hang(made);
      pendulum.hang(made);
      break;
    }
    case WorldKind::mlcp:
      solver = std::make_unique<btMLCPSolver>(&direct_solver);
      make<btDiscreteDynamicsWorld>(way);
      // solve each island separately, as Bullet recommends
      world->getSolverInfo().m_minimumSolverBatchSize = 1;
      break;
    default:
      make<btDiscreteDynamicsWorld>(way);
  }
  world->addAction(&action);
}

World::~World() {
  if (world != nullptr) world->removeAction(&action);
}

std::vector<std::pair<int, int>> World::pairs() const {
  std::vector<std::pair<int, int>> pairs;
  const auto index_of = [](const btBroadphaseProxy* proxy) {
    return static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex();
  };
  const btBroadphasePairArray& found = world->getPairCache()->getOverlappingPairArray();
  for (int i = 0; i < found.size(); ++i)
    pairs.emplace_back(index_of(found[i].m_pProxy0), index_of(found[i].m_pProxy1));
  return pairs;
}

// Same formula as btDiscreteDynamicsWorld::synchronizeSingleMotionState.
btScalar World::interpolation_time(const btRigidBody& body) const {
  const btScalar local = (*world).*Times::kLocal;
  const btScalar fixed_step = (*world).*Times::kFixedStep;
  return world->getLatencyMotionStateInterpolation() && fixed_step != 0 ? local - fixed_step
                                                                        : local * body.getHitFraction();
}

void World::set(const Operation& settings) {
  const std::size_t variant = settings.variant;
  btContactSolverInfo& info = world->getSolverInfo();
  info.m_splitImpulse = variant % 2;
  info.m_numIterations = 1 + static_cast<int>(variant % 12);
  world->setForceUpdateAllAabbs(variant % 3 != 0);
  world->setLatencyMotionStateInterpolation(variant % 5 != 0);
  world->setSynchronizeAllMotionStates(variant % 7 == 0);
  world->setApplySpeculativeContactRestitution(variant % 11 == 0);
  // Without islands Bullet's own multibody world reads a null pointer.
  world->getSimulationIslandManager()->setSplitIslands(variant % 13 != 0 || pendulum.body != nullptr);
}

}  // namespace polhode::fuzz
