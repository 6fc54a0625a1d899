#pragma once

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "record/sample.h"
#include "world/body_shape.h"
#include "world/contender_world.h"

namespace polhode::demos {

/// A scenario in a Bullet world of its own, all its bodies rotated by one contender. Bodies do not fall
/// asleep.
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

  btDiscreteDynamicsWorld& world() { return world_.world(); }
  /// The scenario's own body, then `others`, then the ground if there is one.
  const btRigidBody& body(std::size_t index = 0) const { return *bodies_.at(index); }

 private:
  void add_body(const Body& body);
  void add_ground(const Ground& ground);
  void add_constraint(const PointToPoint& constraint);
  btRigidBody& keep_body(BodyShape shape, btScalar mass);
  std::optional<RotationState> rotation() const;
  double energy_J(const RotationState& state) const;

  Scenario scenario_;
  std::int64_t steps_ = 0;
  std::vector<BodyShape> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::unique_ptr<btTypedConstraint> constraint_;
  ContenderWorld world_;  ///< after what it uses, so that it is destroyed before
};

}  // namespace polhode::demos
