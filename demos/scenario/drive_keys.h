#pragma once

#include "scenario/drive.h"
#include "scenario/key.h"

/// The keys of torque laws and rotors, for any visitor: see scenario_keys.h.
namespace polhode::demos {

inline constexpr Range kCoefficient{0.0, 1e9};
inline constexpr Range kGravitationalParameter{1e-9, 1e15};  // the Earth's is 4e14
inline constexpr Range kTime{0.0, 1e11};

template <class Visitor>
void visit_keys(Visitor& visitor, GravityGradient& planet) {
  visitor.number({"mu", Presence::required, kGravitationalParameter, "m^3/s^2"}, planet.mu);
  visitor.vector({"centre", Presence::optional, kPlace, "m"}, planet.centre_W);
}

template <class Visitor>
void visit_keys(Visitor& visitor, MagneticDipole& magnet) {
  visitor.vector({"dipole_B", Presence::required, kAnySign, "A m^2"}, magnet.dipole_B);
  visitor.vector({"field", Presence::required, kAnySign, "T"}, magnet.field_W);
}

template <class Visitor>
void visit_keys(Visitor& visitor, OrientationSpring& spring) {
  visitor.orientation(
      {"orientation", Presence::optional, kAnyLength, "", ", not all 0; made a unit quaternion"},
      spring.target_WB);
  visitor.number({"stiffness", Presence::required, kCoefficient, "N m/rad"}, spring.stiffness);
}

template <class Visitor>
void visit_keys(Visitor& visitor, RateDamping& damping) {
  visitor.vector({"coefficients_B", Presence::required, kCoefficient, "N m s"}, damping.coefficients_B);
}

template <class Visitor>
void visit_keys(Visitor& visitor, InternalDamping& damping) {
  visitor.number({"moment", Presence::required, kInertiaRange, "kg m^2"}, damping.moment);
  visitor.number({"coefficient", Presence::required, kCoefficient, "N m s"}, damping.coefficient);
}

template <class Visitor>
void visit_keys(Visitor& visitor, MotorTorque& torque) {
  visitor.vector({"torque_B", Presence::required, kAnySign, "N m"}, torque.torque_B);
  visitor.number({"from", Presence::optional, kTime, "s", "; rounded to whole steps"}, torque.from_s);
  visitor.number({"until", Presence::optional, kTime, "s", ", not below `from`; rounded to whole steps"},
                 torque.until_s);
}

template <class Visitor>
void visit_keys(Visitor& visitor, Drive& drive) {
  visitor.vector({"rotor_momentum", Presence::if_set, kAnySign,
                  "kg m^2/s, body axes: initial momentum of the rotors inside the body"},
                 drive.rotor_momentum_B);
  visitor.list({"rotor_torque", Presence::if_set}, drive.motor_torques);
  visitor.choice({"torque_law", Presence::if_set}, "kind", "torque law",
                 Kinds<GravityGradient, MagneticDipole, OrientationSpring, RateDamping, InternalDamping>{},
                 drive.law);
}

}  // namespace polhode::demos
