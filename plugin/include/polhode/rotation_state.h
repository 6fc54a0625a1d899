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
/// Between two steps the members agree: omega_W = (R_WB I_B^-1 R_WB^T) L_W, and R_WB is q_WB's matrix. Only a
/// scheme that declares `rotation: lost` (SchemeDescription) may keep an R_WB that is no rotation; its q_WB
/// is then the rotation nearest to it, and that is what Bullet is given, whose collisions need one.
struct RotationState {
  Quaternion q_WB = Quaternion::Identity();  ///< orientation, v_W = q_WB v_B, unit length
  Matrix3 R_WB = Matrix3::Identity();        ///< its matrix, or what the scheme keeps in its place
  Vector3 omega_W = Vector3::Zero();         ///< angular velocity, rad/s
  Vector3 L_W = Vector3::Zero();             ///< angular momentum about the centre of mass, kg m^2/s

  bool all_finite() const {
    // 0 times a finite number is 0, times any other NaN.
    return (0.0 * q_WB.coeffs()).sum() + (0.0 * R_WB).sum() + (0.0 * omega_W).sum() + (0.0 * L_W).sum() ==
           0.0;
  }

  /// Rotational kinetic energy (1/2) omega . L, in J.
  double energy() const { return 0.5 * omega_W.dot(L_W); }
};

}  // namespace polhode
