#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace polhode {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
/// Unaligned on purpose: an application compiled with AVX would otherwise lay it out differently from the
/// library it links.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

/// The rotation of one body, in double precision whatever Bullet's own precision is.
/// Frames: W the world, B the body (origin in the centre of mass, axes along the principal axes); a suffix
/// says in which of them a vector is expressed. SI units.
///
/// Between two steps the members agree: L_W = (R_WB I_B R_WB^T) omega_W + R_WB h, and R_WB is q_WB's matrix.
/// Only a scheme that declares `rotation: lost` (SchemeDescription) may keep an R_WB that is no rotation; its
/// q_WB is then the rotation nearest to it, and that is what Bullet is given, whose collisions need one.
///
/// h is the angular momentum of rotors inside the body (wheels, propellers), beside what the body's own inertia
/// has. If I_B counts the rotors in as if they were locked, h is their moment times their speed relative to the
/// body; if it leaves their moment about their axes out, h is all their momentum about these.
struct RotationState {
  Quaternion q_WB = Quaternion::Identity();    ///< orientation, v_W = q_WB v_B, unit length
  Matrix3 R_WB = Matrix3::Identity();          ///< its matrix, or what the scheme keeps in its place
  Vector3 omega_W = Vector3::Zero();           ///< angular velocity, rad/s
  Vector3 L_W = Vector3::Zero();               ///< angular momentum about the centre of mass, kg m^2/s
  Vector3 rotor_momentum_B = Vector3::Zero();  ///< h, the part of it that rotors carry, kg m^2/s

  bool all_finite() const {
    // 0 times a finite number is 0, times any other NaN.
    return (0.0 * q_WB.coeffs()).sum() + (0.0 * R_WB).sum() + (0.0 * omega_W).sum() + (0.0 * L_W).sum() +
               (0.0 * rotor_momentum_B).sum() ==
           0.0;
  }

  bool has_rotor() const { return !rotor_momentum_B.isZero(0.0); }

  /// Rotational kinetic energy (1/2) omega . I omega of the body without that of its rotors, in J.
  double energy() const {
    return 0.5 * omega_W.dot(has_rotor() ? Vector3(L_W - R_WB * rotor_momentum_B) : L_W);
  }
};

}  // namespace polhode
