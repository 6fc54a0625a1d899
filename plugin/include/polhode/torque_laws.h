#pragma once

#include <functional>

#include "polhode/torque_law.h"

/// Torque laws that ship. Each throws std::invalid_argument for parameters that are not finite or out of their range.
namespace polhode {

/// The torque of a planet's gravity on a body in its orbit, 3 mu / r^5 r x I_W r, r from the planet's centre to the body
/// (P. C. Hughes, Spacecraft Attitude Dynamics (1986), chapter 8). It does not move the body: that is gravity's part.
/// mu: gravitational parameter, m^3/s^2, > 0; 3.986e14 for the Earth. centre_W: m.
TorqueLaw gravity_gradient(double mu, const Vector3& centre_W = Vector3::Zero());

/// The torque of a magnetic field on a dipole that is fixed in the body, m x b.
/// dipole_B: A m^2. field_W: T, constant or where and when the body is.
TorqueLaw magnetic_dipole(const Vector3& dipole_B, const Vector3& field_W);
TorqueLaw magnetic_dipole_in_field(const Vector3& dipole_B,
                                   std::function<Vector3(const TorqueLawInput&)> field_W);

/// A spring that turns the body towards an orientation by the shortest way, -stiffness times the rotation vector from
/// there, with the potential energy (1/2) stiffness angle^2. stiffness: N m/rad, >= 0.
TorqueLaw orientation_spring(const Quaternion& target_WB, double stiffness);

/// Damps the angular velocity about each axis of the body, -coefficient omega. N m s, each >= 0. With TorqueLawOrder::two
/// a step must be shorter than moment / coefficient.
TorqueLaw rate_damping(const Vector3& coefficients_B);
TorqueLaw rate_damping(double coefficient);

/// Loses energy inside the body, whose angular momentum stays: a damper about each axis, a rotor of this moment that
/// the body drags along, coefficient (omega - h / moment). In the end both turn as one, about the axis of largest
/// moment (W. T. Thomson, Introduction to Space Dynamics (1961)). The scheme must take rotors.
/// moment: kg m^2, > 0, which inertia_B leaves out; coefficient: N m s, >= 0.
TorqueLaw internal_damping(double moment, double coefficient);

}  // namespace polhode
