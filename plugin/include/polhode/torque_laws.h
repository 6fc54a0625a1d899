#pragma once

#include <functional>

#include "polhode/torque_law.h"

/// Built-in torque laws. Each throws std::invalid_argument if a parameter is not finite or out of range.
namespace polhode {

/// Returns the torque of a planet's gravity gradient on an orbiting body, 3 mu / r^5 r x I_W r, with r from
/// the planet's centre to the body (P. C. Hughes, Spacecraft Attitude Dynamics (1986), chapter 8). The
/// gravitational force itself is not included.
/// @param mu gravitational parameter, m^3/s^2, > 0; 3.986e14 for the Earth
/// @param centre_W the planet's centre, m
TorqueLaw gravity_gradient(double mu, const Vector3& centre_W = Vector3::Zero());

/// Returns the torque m x b of a magnetic field on a dipole fixed in the body.
/// @param dipole_B A m^2
/// @param field_W T; constant, or a function of the body's motion, such as its time and position
TorqueLaw magnetic_dipole(const Vector3& dipole_B, const Vector3& field_W);
TorqueLaw magnetic_dipole_in_field(const Vector3& dipole_B,
                                   std::function<Vector3(const TorqueLawInput&)> field_W);

/// Returns the torque of a spring that rotates the body towards an orientation by the shortest way:
/// -stiffness times the rotation vector from the target. The potential energy is (1/2) stiffness angle^2.
/// @param stiffness N m/rad, >= 0
TorqueLaw orientation_spring(const Quaternion& target_WB, double stiffness);

/// Returns a torque that damps the angular velocity about each body axis: -coefficient omega. With
/// TorqueLawOrder::two, dt must be shorter than moment / coefficient.
/// @param coefficients_B N m s, each >= 0
TorqueLaw rate_damping(const Vector3& coefficients_B);
TorqueLaw rate_damping(double coefficient);

/// Returns a torque that dissipates energy inside the body and keeps its angular momentum. About each axis a
/// damper drags along a rotor of the given moment, with the torque coefficient (omega - h / moment). In the
/// end both rotate as one about the axis of largest moment (W. T. Thomson, Introduction to Space Dynamics
/// (1961)). Requires a scheme that takes rotors.
/// @param moment kg m^2, > 0, not included in inertia_B
/// @param coefficient N m s, >= 0
TorqueLaw internal_damping(double moment, double coefficient);

}  // namespace polhode
