#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <memory>

#include "polhode/rotation_state.h"
#include "scenario/scenario.h"
#include "world/contender_world.h"

namespace polhode::demos {

/// A body of a scenario in a contender's world: a rigid body, or a multibody without links. The destructor
/// removes it from the world.
class ScenarioBody {
 public:
  ScenarioBody() = default;
  ScenarioBody(const ScenarioBody&) = delete;
  ScenarioBody& operator=(const ScenarioBody&) = delete;
  virtual ~ScenarioBody() = default;

  /// Returns the collision object: the rigid body, or the collider of the multibody.
  virtual btCollisionObject& object() = 0;

  /// @name The values in Bullet
  /// @{
  virtual RotationState rotation() const = 0;
  virtual Vector3 velocity_W() const = 0;
  virtual Vector3 inertia_B() const = 0;
  /// @}

  /// @name Forces and torques during the next step
  /// @{
  virtual void apply_torque(const Vector3& torque_W) = 0;
  /// Acts on the centre of mass, like gravity.
  virtual void apply_acceleration(const Vector3& acceleration_W) = 0;
  /// Acts on the rotors of a body that Bullet rotates, as by motors inside the body.
  virtual void apply_rotor_torque(const Vector3& torque_B) = 0;
  /// @}

  /// Fixes a point of the body to its place in the world with a constraint.
  virtual void pin(const Vector3& pivot_B) = 0;
};

/// Adds the body to the world, which must outlive it.
/// @throws std::invalid_argument for a start that start_motion refuses
std::unique_ptr<ScenarioBody> make_scenario_body(ContenderWorld& world, const Body& description);

}  // namespace polhode::demos
