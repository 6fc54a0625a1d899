#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <memory>

#include "polhode/bullet/rotation_control.h"
#include "record/contender.h"

namespace polhode::demos {

/// An empty world whose bodies one contender rotates: a RotationWorld for a scheme, a plain
/// btDiscreteDynamicsWorld for one of Bullet's modes. Bodies in it must outlive it.
class ContenderWorld {
 public:
  explicit ContenderWorld(const Contender& contender);

  btDiscreteDynamicsWorld& world() { return *world_; }
  /// The library's part in it; null in a plain world.
  const RotationControl* rotation() const { return rotation_; }

  /// Gives a body the mode's flag and no other in a plain world. Call it for each body that is added.
  void set_gyroscopic_flag(btRigidBody& body) const;

 private:
  std::variant<SchemePointer, BulletMode> method_;
  // Declared in the order in which they use each other.
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  const RotationControl* rotation_ = nullptr;
};

}  // namespace polhode::demos
