#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "benchmark/scene_start.h"
#include "polhode/bullet/rotation_plugin.h"

namespace polhode::benchmarks {

enum class RotatedBy {
  bullet,           ///< a plain world with Bullet's default flags
  rotation_world,   ///< polhode::RotationWorld
  rotation_plugin,  ///< a plain world with polhode::RotationPlugin attached
};

/// A scene in its own world, set up as by an application. Every body has a motion state. No body sleeps, so
/// that each step moves every body.
class SceneWorld {
 public:
  /// Null `scheme`: a plain world.
  SceneWorld(const SceneStart& start, RotatedBy rotated_by, const SchemePointer& scheme);
  ~SceneWorld();
  SceneWorld(const SceneWorld&) = delete;
  SceneWorld& operator=(const SceneWorld&) = delete;

  void step() { world_->stepSimulation(kTimeStep, 0); }

  /// Applies a small torque impulse to every body, with alternating sign.
  void kick();

  btRigidBody& body(std::size_t index) { return *bodies_[index]; }
  std::size_t bodies() const { return bodies_.size(); }
  /// Returns 0 for a plain world.
  std::uint64_t incidents() const { return rotation_ == nullptr ? 0 : rotation_->incidents(); }

 private:
  void make_world(RotatedBy rotated_by, const SchemePointer& scheme);
  void add_floor();
  void add_box(const BoxStart& start);

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  RotationControl* rotation_ = nullptr;
  std::vector<std::unique_ptr<btBoxShape>> shapes_;
  std::vector<std::unique_ptr<btDefaultMotionState>> motion_states_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::unique_ptr<btBoxShape> floor_shape_;
  std::unique_ptr<btRigidBody> floor_;
  std::unique_ptr<RotationPlugin> plugin_;
  btScalar kick_sign_ = 1;
};

}  // namespace polhode::benchmarks
