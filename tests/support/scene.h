#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorldMt.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace polhode::testing {

/// The solver that each Bullet world expects.
template <class World>
std::unique_ptr<btConstraintSolver> make_solver() {
  if constexpr (std::is_base_of_v<btDiscreteDynamicsWorldMt, World>) {
    return std::make_unique<btConstraintSolverPoolMt>(1);
  } else if constexpr (std::is_base_of_v<btMultiBodyDynamicsWorld, World>) {
    return std::make_unique<btMultiBodyConstraintSolver>();
  } else {
    return std::make_unique<btSequentialImpulseConstraintSolver>();
  }
}

template <class World>
std::unique_ptr<World> make_world(btDispatcher* dispatcher, btBroadphaseInterface* broadphase,
                                  btConstraintSolver* solver, btCollisionConfiguration* configuration) {
  if constexpr (std::is_base_of_v<btDiscreteDynamicsWorldMt, World>) {
    return std::make_unique<World>(dispatcher, broadphase, static_cast<btConstraintSolverPoolMt*>(solver),
                                   nullptr, configuration);
  } else if constexpr (std::is_base_of_v<btMultiBodyDynamicsWorld, World>) {
    return std::make_unique<World>(dispatcher, broadphase, static_cast<btMultiBodyConstraintSolver*>(solver),
                                   configuration);
  } else {
    return std::make_unique<World>(dispatcher, broadphase, solver, configuration);
  }
}

/// A world of any kind with its bodies and the objects that the world uses; initially without gravity.
template <class World = btDiscreteDynamicsWorld>
class Scene {
 public:
  Scene() { world_->setGravity(btVector3(0, 0, 0)); }

  ~Scene() {
    for (const auto& joint : joints_) world_->removeConstraint(joint.get());
    for (const auto& body : bodies_) world_->removeRigidBody(body.get());
  }

  World& world() { return *world_; }

  btCollisionShape& box(const btVector3& half_extents) {
    shapes_.push_back(std::make_unique<btBoxShape>(half_extents));
    return *shapes_.back();
  }

  /// Adds a dynamic body (static with mass 0) that never sleeps by default.
  btRigidBody& add(btScalar mass, const btVector3& inertia_B, const btTransform& pose,
                   btCollisionShape& shape, btMotionState* motion_state = nullptr) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, motion_state, &shape, inertia_B);
    info.m_startWorldTransform = pose;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    static_cast<btDynamicsWorld&>(*world_).addRigidBody(&body);  // the world's class may hide this overload
    if (mass != 0) body.setActivationState(DISABLE_DEACTIVATION);
    return body;
  }

  /// Adds a free body of 1 kg that spins at omega_W in empty space.
  btRigidBody& add_free(const btVector3& inertia_B, const btVector3& omega_W,
                        const btQuaternion& q_WB = btQuaternion::getIdentity()) {
    const btScalar spacing = 10;
    const btVector3 origin(spacing * static_cast<btScalar>(bodies_.size()), 0, 0);
    btRigidBody& body = add(1, inertia_B, btTransform(q_WB, origin), box(btVector3(1, 1, 1)));
    body.setAngularVelocity(omega_W);
    return body;
  }

  /// Adds a body that the application moves. With a mass it can become dynamic later; without, Bullet also
  /// treats it as static.
  btRigidBody& add_kinematic(const btTransform& pose, btScalar mass, const btVector3& inertia_B) {
    btRigidBody& body = add(mass, inertia_B, pose, box(btVector3(1, 1, 1)));
    world_->removeRigidBody(&body);
    body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    world_->addRigidBody(&body);
    body.setActivationState(DISABLE_DEACTIVATION);
    return body;
  }

  /// Adds a static floor whose top is at height 0, z up.
  btRigidBody& add_floor() {
    const btTransform pose(btQuaternion::getIdentity(), btVector3(0, 0, -1));
    return add(0, btVector3(0, 0, 0), pose, box(btVector3(50, 50, 1)));
  }

  /// Adds a box with the inertia of its shape.
  btRigidBody& add_box(const btVector3& half_extents, btScalar mass, const btTransform& pose) {
    btCollisionShape& shape = box(half_extents);
    btVector3 inertia_B;
    shape.calculateLocalInertia(mass, inertia_B);
    return add(mass, inertia_B, pose, shape);
  }

  /// Adds a Bullet joint, given its constructor arguments; the joined bodies do not collide.
  template <class Joint, class... Arguments>
  Joint& join(Arguments&&... arguments) {
    auto joint = std::make_unique<Joint>(std::forward<Arguments>(arguments)...);
    Joint& added = *joint;
    joints_.push_back(std::move(joint));
    world_->addConstraint(&added, true);
    return added;
  }

  /// Adds any shape, owned by the scene.
  template <class Shape, class... Arguments>
  Shape& shape(Arguments&&... arguments) {
    auto shape = std::make_unique<Shape>(std::forward<Arguments>(arguments)...);
    Shape& added = *shape;
    shapes_.push_back(std::move(shape));
    return added;
  }

  /// Removes the body from the world and deletes it.
  void remove(btRigidBody& body) {
    world_->removeRigidBody(&body);
    for (auto it = bodies_.begin(); it != bodies_.end(); ++it) {
      if (it->get() == &body) {
        bodies_.erase(it);
        return;
      }
    }
  }

  const std::vector<std::unique_ptr<btRigidBody>>& bodies() const { return bodies_; }

  void step(btScalar dt, int count = 1) {
    for (int i = 0; i < count; ++i) world_->stepSimulation(dt, 0, dt);
  }

 private:
  btSoftBodyRigidBodyCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btConstraintSolver> solver_ = make_solver<World>();
  std::unique_ptr<World> world_ =
      make_world<World>(&dispatcher_, &broadphase_, solver_.get(), &configuration_);
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

}  // namespace polhode::testing
