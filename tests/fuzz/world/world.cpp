#include "fuzz/world/world.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>

#include "polhode/bullet/rotation_world.h"

namespace polhode::fuzz {

namespace {

btDefaultCollisionConstructionInfo small_pools() {
  constexpr int kPool = 64;
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = kPool;
  info.m_defaultMaxCollisionAlgorithmPoolSize = kPool;
  return info;
}

}  // namespace

World::World(Way way, std::function<void()> act) : configuration(small_pools()), action(std::move(act)) {
  if (way == Way::rotation_world) {
    auto made = std::make_unique<RotationWorld<btDiscreteDynamicsWorld>>(&dispatcher, &broadphase, &solver,
                                                                         &configuration);
    rotation = &made->rotation();
    world = std::move(made);
  } else {
    world = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher, &broadphase, &solver, &configuration);
  }
  if (way == Way::plugin) {
    plugin = std::make_unique<RotationPlugin>(*world);
    rotation = &plugin->rotation();
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

void World::set(const Operation& settings) {
  const std::size_t variant = settings.variant;
  btContactSolverInfo& info = world->getSolverInfo();
  info.m_splitImpulse = variant % 2;
  info.m_numIterations = 1 + static_cast<int>(variant % 12);
  world->setForceUpdateAllAabbs(variant % 3 != 0);
  world->setLatencyMotionStateInterpolation(variant % 5 != 0);
  world->setSynchronizeAllMotionStates(variant % 7 == 0);
  world->setApplySpeculativeContactRestitution(variant % 11 == 0);
  world->getSimulationIslandManager()->setSplitIslands(variant % 13 != 0);
}

}  // namespace polhode::fuzz
