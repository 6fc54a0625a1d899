#include "tools/run/host/other_worlds.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorldMt.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <cmath>
#include <initializer_list>

#include "tools/run/host/scene.h"

namespace polhode::run_test {

namespace {

double step(btDynamicsWorld& world) {
  TumblingBody body;
  world.setGravity(btVector3(0, 0, 0));
  world.addRigidBody(&body.body());
  for (int i = 0; i < kSteps; ++i) world.stepSimulation(kDt, 1, kDt);
  world.removeRigidBody(&body.body());
  return body.energy_ratio();
}

class OwnIslands : public btSimulationIslandManager {};

class WorldWithOwnIslands : public btDiscreteDynamicsWorld {
 public:
  explicit WorldWithOwnIslands(Surroundings& surroundings)
      : btDiscreteDynamicsWorld(&surroundings.dispatcher, &surroundings.broadphase, &surroundings.solver,
                                &surroundings.configuration) {
    bullets_ = m_islandManager;
  }
  ~WorldWithOwnIslands() override { m_islandManager = bullets_; }
  void use_own_islands() {
    bullets_ = m_islandManager;
    m_islandManager = &own_;
  }

 private:
  OwnIslands own_;
  btSimulationIslandManager* bullets_;
};

}  // namespace

double step_a_deformable_world() {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btDeformableBodySolver deformable_solver;
  btDeformableMultiBodyConstraintSolver solver;
  solver.setDeformableSolver(&deformable_solver);
  btDeformableMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration,
                                           &deformable_solver);
  return step(world);
}

double step_a_world_with_its_own_islands() {
  Surroundings surroundings;
  WorldWithOwnIslands world(surroundings);
  world.use_own_islands();
  return step(world);
}

double step_a_world_that_gets_its_own_islands() {
  Surroundings surroundings;
  WorldWithOwnIslands world(surroundings);
  world.stepSimulation(kDt, 0);
  world.use_own_islands();
  return step(world);
}

double step_each_kind_of_world() {
  Surroundings surroundings;
  btSoftBodyRigidBodyCollisionConfiguration soft_configuration;
  btMultiBodyConstraintSolver multibody_solver;
  btConstraintSolverPoolMt solvers(1);
  btDispatcher* const dispatcher = &surroundings.dispatcher;
  btBroadphaseInterface* const broadphase = &surroundings.broadphase;
  btSoftRigidDynamicsWorld soft(dispatcher, broadphase, &surroundings.solver, &soft_configuration);
  btMultiBodyDynamicsWorld multibody(dispatcher, broadphase, &multibody_solver, &surroundings.configuration);
  btSoftMultiBodyDynamicsWorld soft_multibody(dispatcher, broadphase, &multibody_solver, &soft_configuration);
  btDiscreteDynamicsWorldMt parallel(dispatcher, broadphase, &solvers, nullptr, &surroundings.configuration);
  double worst = 1.0;
  for (btDynamicsWorld* world :
       std::initializer_list<btDynamicsWorld*>{&soft, &multibody, &soft_multibody, &parallel}) {
    const double ratio = step(*world);
    if (std::abs(ratio - 1.0) > std::abs(worst - 1.0)) worst = ratio;
  }
  return worst;
}

void step_a_multibody() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  btMultiBody multibody(0, 1, btVector3(1, 2, 3), false, false);
  multibody.finalizeMultiDof();
  world.addMultiBody(&multibody);
  step(world);
  world.removeMultiBody(&multibody);
}

}  // namespace polhode::run_test
