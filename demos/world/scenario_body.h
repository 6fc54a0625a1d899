#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <memory>

#include "polhode/rotation_state.h"
#include "scenario/scenario.h"
#include "world/contender_world.h"

namespace polhode::demos {

/// A body of a scenario in a contender's world: a rigid body, or a multibody without links. Its destructor
/// removes it from the world.
class ScenarioBody {
 public:
  ScenarioBody() = default;
  ScenarioBody(const ScenarioBody&) = delete;
  ScenarioBody& operator=(const ScenarioBody&) = delete;
  virtual ~ScenarioBody() = default;

  /// Returns what Bullet collides and draws: the rigid body, or the collider of the multibody.
  virtual btCollisionObject& object() = 0;

  /// @name The values as Bullet has them
  /// @{
  virtual RotationState rotation() const = 0;
  virtual Vector3 velocity_W() const = 0;
  virtual Vector3 inertia_B() const = 0;
  /// @}

  /// @name What acts during the next step
  /// Bullet clears it after that.
  /// @{
  virtual void apply_torque(const Vector3& torque_W) = 0;
  /// As gravity does, on the centre of mass.
  virtual void apply_acceleration(const Vector3& acceleration_W) = 0;
  /// On the rotors of a body that Bullet rotates, by motors inside the body.
  virtual void apply_rotor_torque(const Vector3& torque_B) = 0;
  /// @}

  /// Holds a point of the body in its place in the world by a constraint.
  virtual void pin(const Vector3& pivot_B) = 0;
};

/// Adds the body to the world, which must outlive it.
/// @throws std::invalid_argument for a start that start_motion refuses.
std::unique_ptr<ScenarioBody> make_scenario_body(ContenderWorld& world, const Body& description);

}  // namespace polhode::demos
