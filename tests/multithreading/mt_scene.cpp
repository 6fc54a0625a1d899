#include "multithreading/mt_scene.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolverMt.h>

#include "multithreading/digest.h"
#include "polhode/bullet/rotation_world.h"

namespace polhode::testing {

namespace {

// One per thread for the largest number of threads; with fewer, threads would spin while waiting for a solver.
constexpr int kSolvers = 8;

std::unique_ptr<btCollisionDispatcher> make_dispatcher(BulletParts parts,
                                                       btCollisionConfiguration& configuration) {
  if (parts.parallel_narrowphase) return std::make_unique<btCollisionDispatcherMt>(&configuration);
  return std::make_unique<btCollisionDispatcher>(&configuration);
}

std::unique_ptr<btConstraintSolver> make_large_island_solver(BulletParts parts) {
  if (parts.parallel_solver) return std::make_unique<btSequentialImpulseConstraintSolverMt>();
  return nullptr;
}

}  // namespace

std::string to_string(Way way) {
  switch (way) {
    case Way::plain_bullet:
      return "PlainBullet";
    case Way::rotation_world:
      return "InRotationWorld";
    case Way::rotation_plugin:
      return "UnderRotationPlugin";
  }
  return "";
}

std::string to_string(BulletParts parts) {
  return std::string(parts.parallel_narrowphase ? "ParallelNarrowphase" : "SequentialNarrowphase") +
         (parts.parallel_solver ? "ParallelSolver" : "SolverPerIsland");
}

MtScene::MtScene(Way way, BulletParts parts)
    : dispatcher_(make_dispatcher(parts, configuration_)),
      solver_pool_(kSolvers),
      large_island_solver_(make_large_island_solver(parts)) {
  if (way == Way::rotation_world) {
    auto world = std::make_unique<RotationWorld<btDiscreteDynamicsWorldMt>>(
        dispatcher_.get(), &broadphase_, &solver_pool_, large_island_solver_.get(), &configuration_);
    rotation_ = &world->rotation();
    world_ = std::move(world);
  } else {
    world_ = std::make_unique<btDiscreteDynamicsWorldMt>(dispatcher_.get(), &broadphase_, &solver_pool_,
                                                         large_island_solver_.get(), &configuration_);
  }
  if (way == Way::rotation_plugin) rotation_ = &plugin_.emplace(*world_).rotation();
  world_->setGravity(btVector3(0, 0, 0));
}

MtScene::~MtScene() {
  plugin_.reset();
  for (const auto& body : bodies_) world_->removeRigidBody(body.get());
}

btCollisionShape& MtScene::box(const btVector3& half_extents) {
  shapes_.push_back(std::make_unique<btBoxShape>(half_extents));
  return *shapes_.back();
}

btRigidBody& MtScene::add(btScalar mass, const btVector3& inertia_B, const btTransform& pose,
                          btCollisionShape& shape) {
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia_B);
  info.m_startWorldTransform = pose;
  bodies_.push_back(std::make_unique<btRigidBody>(info));
  world_->addRigidBody(bodies_.back().get());
  return *bodies_.back();
}

void MtScene::step(btScalar dt) {
  world_->stepSimulation(dt, 0, dt);
}

std::uint64_t MtScene::digest() const {
  Digest digest;
  for (const auto& body : bodies_) {
    digest.add(*body);
    if (rotation_ != nullptr && rotation_->manages(*body)) digest.add(rotation_->rotation_of(*body));
  }
  return digest.value();
}

}  // namespace polhode::testing
