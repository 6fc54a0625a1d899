#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "record/sample.h"
#include "world/body_shape.h"
#include "world/contender_world.h"
#include "world/driver.h"
#include "world/scenario_body.h"

namespace polhode::demos {

/// A scenario in a Bullet world of its own, all its bodies rotated by one contender. Bodies do not fall
/// asleep.
class ScenarioWorld {
 public:
  /// @throws std::invalid_argument for a start that start_motion refuses, and as require_can_run.
  ScenarioWorld(const Scenario& scenario, const Contender& contender);

  void step();

  /// The recorded body as it is now, nothing if it has diverged. For a scheme the rotation is the library's
  /// double state, for Bullet's modes it follows from the body's basis and velocity and those of its wheels, for
  /// Bullet's multibody from its quaternion and velocity.
  std::optional<Sample> sample() const;

  /// The recorded body's moments of inertia as Bullet has rounded them: of a rigid body it keeps the inverses.
  Vector3 inertia_B() const { return bodies_.front()->inertia_B(); }
  /// The length of a step as Bullet has rounded it.
  double dt_s() const { return static_cast<double>(static_cast<btScalar>(scenario_.dt)); }

  btDiscreteDynamicsWorld& world() { return world_.world(); }
  /// The scenario's own body, then `others`: a btRigidBody, or a multibody's btMultiBodyLinkCollider.
  const btCollisionObject& body(std::size_t index = 0) const { return bodies_.at(index)->object(); }

 private:
  void add_body(const Body& description);
  void add_ground(const Ground& ground);
  std::optional<RotationState> rotation() const;
  double energy_J(const RotationState& state) const;

  Scenario scenario_;
  std::int64_t steps_ = 0;
  BodyShape plane_;
  std::unique_ptr<btRigidBody> ground_;
  ContenderWorld
      world_;  ///< after the ground, which has to outlive it, and before the bodies, which leave it
  std::vector<std::unique_ptr<ScenarioBody>> bodies_;
  std::vector<Driver> drivers_;
};

}  // namespace polhode::demos
