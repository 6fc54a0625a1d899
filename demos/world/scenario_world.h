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

/// A scenario in its own Bullet world, with all bodies rotated by one contender. Bodies do not sleep.
class ScenarioWorld {
 public:
  /// @throws std::invalid_argument for a start that start_motion refuses, and as require_can_run
  ScenarioWorld(const Scenario& scenario, const Contender& contender);

  void step();

  /// Returns the recorded body's present state, or nothing if it has diverged. The rotation is the library's
  /// double-precision state for a scheme, comes from the body's basis and velocity and those of its wheels
  /// for Bullet's modes, and from its quaternion and velocity for Bullet's multibody.
  std::optional<Sample> sample() const;

  /// Returns the recorded body's moments of inertia as rounded by Bullet, which stores the inverses for a
  /// rigid body.
  Vector3 inertia_B() const { return bodies_.front()->inertia_B(); }
  /// Returns the length of a step as rounded by Bullet.
  double dt_s() const { return static_cast<double>(static_cast<btScalar>(scenario_.dt)); }

  btDiscreteDynamicsWorld& world() { return world_.world(); }
  /// Returns the scenario's own body, then `others`: a btRigidBody, or a multibody's btMultiBodyLinkCollider.
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
  ContenderWorld world_;  ///< outlives the bodies, and the ground outlives it
  std::vector<std::unique_ptr<ScenarioBody>> bodies_;
  std::vector<Driver> drivers_;
};

}  // namespace polhode::demos
