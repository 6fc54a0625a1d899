#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>

#include "bullet/body/composite_body.h"
#include "polhode/bullet/precision.h"
#include "polhode/rotation_state.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// A btRigidBody outside any world that represents a btMultiBody in a batch, so that one implementation steps
/// both. The multibody is read before a stage, and the result is written to the multibody after the stage.
///
/// Differences between a btMultiBody and a rigid body:
///
///   gyroscopic term     explicit: turned off (setUseGyroTerm) during the solve
///   largest velocity    Bullet clamps each coordinate (setMaxCoordinateVelocity, 100 by default): during the
///                       solve the limit is raised to the body's present speed
///   damping             grows with the speed and is applied in the solve: treated as a torque
///   inverse inertia     the solver reads it from the base: the effective inertia cannot be given
///   orientation         a quaternion q_BW, the inverse of q_WB
///   turn                at most pi/4 a step: replaced after the integration
///   fixed links         the proxy is the composite body, with its centre of mass and principal axes;
///                       Bullet's centrifugal forces are cancelled in the solve, and the base follows the
///                       centre of mass
class MultibodyProxy {
 public:
  explicit MultibodyProxy(btMultiBody& multibody);

  MultibodyProxy(const MultibodyProxy&) = delete;
  MultibodyProxy& operator=(const MultibodyProxy&) = delete;
  /// Returns the proxy whose body() is `body`.
  static MultibodyProxy& of(const btRigidBody& body) {
    return *static_cast<MultibodyProxy*>(body.getUserPointer());
  }

  btMultiBody& multibody() { return multibody_; }
  btRigidBody& body() { return body_; }
  const btRigidBody& body() const { return body_; }

  /// Prefetches the data of the functions below.
  void prefetch() const;
  /// Reads the motion, the inertia, the forces, and whether Bullet moves the multibody at present.
  void read() noexcept;
  bool is_multibody_finite() const;
  /// Replaces values of the multibody that are not finite by those of the proxy, which the library has
  /// sanitized.
  void take_out_non_finite();
  /// Writes the proxy's velocity and torque to the multibody, and changes its settings for the solve. Call
  /// right before the solve.
  void give_to_solver(bool is_constrained);
  /// Restores the settings and reads the velocity with which Bullet turned. Call after Bullet's integration.
  void read_solved(btScalar dt);
  /// Writes the proxy's angular velocity after a change between two steps; keeps the velocity of the centre
  /// of mass.
  void write_angular_velocity();
  /// Writes the end of the step. Keeps Bullet's motion of the centre of mass if it is finite.
  void write(const Quaternion& q_WC);

 private:
  bool is_moved_by_bullet() const;
  btVector3 centre_from_base_W() const;
  void give_as_composite();
  bool acted(const btVector3& solved_W, btScalar dt) const;
  void write_what_is_not_finite();
  void stop_turning();
  void move_colliders();

  btMultiBody& multibody_;
  CompositeBody composite_;
  btRigidBody body_;
  btMatrix3x3 written_basis_ = btMatrix3x3::getIdentity();
  btQuaternion written_q_BW_ = btQuaternion(0, 0, 0, 0);  // of written_basis_; initially not a rotation
  // The application's settings and forces, which are replaced during the solve.
  bool uses_gyroscopic_term_ = false;
  btScalar largest_velocity_ = 0;
  btVector3 force_W_ = btVector3(0, 0, 0);
  btVector3 torque_W_ = btVector3(0, 0, 0);
  // The present step.
  bool is_constrained_ = false;
  btVector3 given_W_ = btVector3(0, 0, 0);
  CompositeBody::Wrench cancelling_{btVector3(0, 0, 0), btVector3(0, 0, 0)};
  btVector3 given_centre_W_ = btVector3(0, 0, 0);  // centre of mass relative to the base
  btVector3 solved_centre_velocity_ = btVector3(0, 0, 0);
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
