#pragma once

#include "polhode/bullet/rotation_control.h"
#include "scenario/scenario.h"
#include "world/scenario_body.h"

namespace polhode::demos {

/// Drives a body as its scenario says. Where a scheme rotates it, the library is told; where Bullet does, torques are
/// applied before each step, from the motion that the body has then, as users of Bullet do.
class Driver {
 public:
  /// `rotation` is null in a plain world.
  Driver(ScenarioBody& body, const Drive& drive, RotationControl* rotation);

  /// t_s: the time at the start of the step.
  void before_step(double t_s, double dt_s);

 private:
  void pull_to_planet(const GravityGradient& planet);
  void apply_torques(double t_s, const Vector3& motor_torque_B);
  TorqueLawInput motion(double t_s) const;

  ScenarioBody& body_;
  Drive drive_;
  RotationControl* rotation_;
  TorqueLaw law_;                             ///< empty: none
  Vector3 motor_torque_B_ = Vector3::Zero();  ///< as the library was told last
};

}  // namespace polhode::demos
