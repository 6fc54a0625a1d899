#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <memory>

#include "polhode/bullet/rotation_control.h"
#include "record/contender.h"

namespace polhode::demos {

/// An empty world whose bodies are rotated by one contender: a RotationWorld for a scheme, a plain
/// btDiscreteDynamicsWorld for one of Bullet's modes, a plain btMultiBodyDynamicsWorld for Bullet's
/// multibody. Bodies must outlive the world or be removed from it.
class ContenderWorld {
 public:
  explicit ContenderWorld(const Contender& contender);

  btDiscreteDynamicsWorld& world() { return *world_; }
  /// Returns the same world if its bodies are multibodies, else null.
  btMultiBodyDynamicsWorld* multibody_world() { return multibody_world_; }
  /// Returns the library's control of the world; null for a plain world.
  RotationControl* rotation() const { return rotation_; }

  /// In a plain world, gives a body the mode's flag and no other. Call it for each body that is added.
  void set_gyroscopic_flag(btRigidBody& body) const;

 private:
  template <class World, class Solver>
  World& make_world();

  decltype(Contender::method) method_;
  // Declared in the order of their dependences.
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  btMultiBodyDynamicsWorld* multibody_world_ = nullptr;
  RotationControl* rotation_ = nullptr;
};

}  // namespace polhode::demos
