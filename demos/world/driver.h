#pragma once

#include "polhode/bullet/rotation_control.h"
#include "scenario/scenario.h"
#include "world/scenario_body.h"

namespace polhode::demos {

/// Applies a scenario's torque law, rotors and motors to a body. A scheme gets them from the library. In a
/// plain world torques are applied before each step, for the present motion, as a Bullet user would.
class Driver {
 public:
  /// `rotation` is null for a plain world.
  Driver(ScenarioBody& body, const Drive& drive, RotationControl* rotation);

  /// `t_s` is the time at the start of the step.
  void before_step(double t_s, double dt_s);

 private:
  void pull_to_planet(const GravityGradient& planet);
  void apply_torques(double t_s, const Vector3& motor_torque_B);
  TorqueLawInput motion(double t_s) const;

  ScenarioBody& body_;
  Drive drive_;
  RotationControl* rotation_;
  TorqueLaw law_;                             ///< empty if there is none
  Vector3 motor_torque_B_ = Vector3::Zero();  ///< as last passed to the library
};

}  // namespace polhode::demos
