#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace polhode {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
/// Unaligned, so that an application compiled with AVX has the same memory layout as the library.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

/// The rotation of one body, in double precision regardless of Bullet's precision. SI units.
/// Frames: W is the world; B is the body, with its origin in the centre of mass and its axes along the
/// principal axes. A suffix names the frame in which a vector is expressed.
///
/// Between steps the members agree: L_W = (R_WB I_B R_WB^T) omega_W + R_WB h, and R_WB is the matrix of q_WB.
/// Only a scheme that declares `rotation: lost` (SchemeDescription) may keep an R_WB that is not a rotation.
/// Its q_WB is then the nearest rotation, which is written to Bullet, since collision detection requires a
/// rotation.
///
/// h is the angular momentum of rotors inside the body (wheels, propellers), in addition to that of the
/// body's own inertia. If I_B includes the rotors as if they were locked, h is their moment times their speed
/// relative to the body. If I_B excludes the rotors' moments about their axes, h is their total momentum
/// about these axes.
struct RotationState {
  Quaternion q_WB = Quaternion::Identity();    ///< orientation, v_W = q_WB v_B, unit length
  Matrix3 R_WB = Matrix3::Identity();          ///< the matrix of q_WB, or the scheme's own matrix
  Vector3 omega_W = Vector3::Zero();           ///< angular velocity, rad/s
  Vector3 L_W = Vector3::Zero();               ///< angular momentum about the centre of mass, kg m^2/s
  Vector3 rotor_momentum_B = Vector3::Zero();  ///< h, the rotors' part of the angular momentum, kg m^2/s

  bool all_finite() const {
    // 0 times a finite number is 0; 0 times infinity or NaN is NaN.
    return (0.0 * q_WB.coeffs()).sum() + (0.0 * R_WB).sum() + (0.0 * omega_W).sum() + (0.0 * L_W).sum() +
               (0.0 * rotor_momentum_B).sum() ==
           0.0;
  }

  bool has_rotor() const { return !rotor_momentum_B.isZero(0.0); }

  /// Returns the rotational kinetic energy (1/2) omega . I omega of the body without its rotors, in J.
  double energy() const {
    return 0.5 * omega_W.dot(has_rotor() ? Vector3(L_W - R_WB * rotor_momentum_B) : L_W);
  }
};

}  // namespace polhode
