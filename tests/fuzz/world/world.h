#pragma once

#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "fuzz/world/furniture.h"
#include "fuzz/world/operation.h"
#include "polhode/bullet/rotation_control.h"
#include "polhode/bullet/rotation_plugin.h"

namespace polhode::fuzz {

enum class Way : std::uint8_t { rotation_world, plugin, plain };

/// Performs the application's operations in an action.
class ScriptedAction final : public btActionInterface {
 public:
  explicit ScriptedAction(std::function<void()> act) : act_(std::move(act)) {}
  void updateAction(btCollisionWorld* /*world*/, btScalar /*dt*/) override { act_(); }
  void debugDraw(btIDebugDraw* /*drawer*/) override {}

 private:
  std::function<void()> act_;
};

/// A Bullet world with one way of rotation, and the objects that the world uses.
struct World {
  World(Way way, WorldKind kind, std::function<void()> act);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Returns true if the library currently rotates bodies of this world.
  bool is_rotated() const { return rotation != nullptr && (plugin == nullptr || plugin->attached()); }
  /// Returns the user indices of the bodies in each overlapping pair, in Bullet's order.
  std::vector<std::pair<int, int>> pairs() const;
  void set(const Operation& settings);
  /// Returns the time by which Bullet extrapolates the pose of a body for its motion state.
  btScalar interpolation_time(const btRigidBody& body) const;

  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btDantzigSolver direct_solver;  // for the MLCP solver
  std::unique_ptr<btConstraintSolver> solver;
  Rope rope;
  Pendulum pendulum;
  ScriptedAction action;
  std::unique_ptr<btDiscreteDynamicsWorld> world;
  RotationControl* rotation = nullptr;
  std::unique_ptr<RotationPlugin> plugin;
  std::uint64_t incidents = 0;  ///< number at the last check
  std::uint64_t reports = 0;    ///< number of calls of the incident handler

 private:
  template <class Base>
  void make(Way way);
};

}  // namespace polhode::fuzz
