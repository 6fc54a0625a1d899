#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "polhode/bullet/rotation_control.h"
#include "record/contender.h"
#include "record/sample.h"
#include "world/body_shape.h"

namespace polhode::demos {

/// A scenario in a Bullet world of its own, all its bodies rotated by one contender: a RotationWorld for a
/// scheme, a plain btDiscreteDynamicsWorld for one of Bullet's modes. Bodies do not fall asleep.
class ScenarioWorld {
 public:
  /// @throws std::invalid_argument for a start that start_motion refuses.
  ScenarioWorld(const Scenario& scenario, const Contender& contender);
  ~ScenarioWorld();
  ScenarioWorld(const ScenarioWorld&) = delete;
  ScenarioWorld& operator=(const ScenarioWorld&) = delete;

  void step();

  /// The recorded body as it is now, nothing if it has diverged. For a scheme the rotation is the library's
  /// double state, for Bullet's modes it follows from the body's basis and velocity.
  std::optional<Sample> sample() const;

  /// The recorded body's moments of inertia as Bullet, which keeps their inverses, has rounded them.
  Vector3 inertia_B() const;
  /// The length of a step as Bullet has rounded it.
  double dt_s() const { return static_cast<double>(static_cast<btScalar>(scenario_.dt)); }

  btDiscreteDynamicsWorld& world() { return *world_; }
  /// The scenario's own body, then `others`, then the ground if there is one.
  const btRigidBody& body(std::size_t index = 0) const { return *bodies_.at(index); }

 private:
  void make_world(const Contender& contender);
  void add_body(const Body& body, const Contender& contender);
  void add_ground(const Ground& ground);
  void add_constraint(const PointToPoint& constraint);
  btRigidBody& keep_body(BodyShape shape, btScalar mass);
  std::optional<RotationState> rotation() const;
  double energy_J(const RotationState& state) const;

  Scenario scenario_;
  std::int64_t steps_ = 0;
  // What the world uses is declared before it, so that it outlives it.
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::vector<BodyShape> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::unique_ptr<btTypedConstraint> constraint_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  RotationControl* rotation_ = nullptr;  ///< part of `world_`; none in a plain world
};

}  // namespace polhode::demos
