#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>

#include "bullet/body/composite_body.h"
#include "polhode/bullet/precision.h"
#include "polhode/rotation_state.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// A btRigidBody of no world that stands in for a btMultiBody in a batch, so that one path steps both. The
/// multibody's numbers are read into it before a stage, and what the library wrote is handed back after it.
///
/// A btMultiBody differs from a rigid body in:
///
///   gyroscopic term     explicit: switched off (setUseGyroTerm) during the solve
///   largest velocity    each coordinate is clamped (setMaxCoordinateVelocity, 100 by default): during the solve
///                       the limit is at least the speed that the body has already
///   damping             grows with the speed, and is applied in the solve: it acts like a torque
///   inverse inertia     the solver takes it from the base: the effective inertia cannot be handed over
///   orientation         a quaternion q_BW, the inverse of q_WB
///   turn                at most pi/4 a step: replaced after the integration
///   fixed links         the proxy is the composite body, with its centre of mass and principal axes; Bullet's
///                       centrifugal forces are cancelled in the solve, and the base is placed by the centre of mass
class MultibodyProxy {
 public:
  explicit MultibodyProxy(btMultiBody& multibody);

  MultibodyProxy(const MultibodyProxy&) = delete;
  MultibodyProxy& operator=(const MultibodyProxy&) = delete;
  /// The proxy whose body() it is.
  static MultibodyProxy& of(const btRigidBody& body) {
    return *static_cast<MultibodyProxy*>(body.getUserPointer());
  }

  btMultiBody& multibody() { return multibody_; }
  btRigidBody& body() { return body_; }
  const btRigidBody& body() const { return body_; }

  /// Asks for what the functions below will need.
  void prefetch() const;
  /// Reads the motion, the inertia, what acts, and whether Bullet moves the multibody at present.
  void read() noexcept;
  bool is_multibody_finite() const;
  /// Where the multibody is not finite it follows the proxy, which the library has set to something finite.
  void take_out_non_finite();
  /// Right before the solve: hands over the velocity and torque of the proxy, and takes the switches.
  void give_to_solver(bool is_constrained);
  /// After Bullet's integration: gives the switches back and reads the velocity with which Bullet turned.
  void read_solved(btScalar dt);
  /// Writes the proxy's angular velocity, which somebody has changed between two steps; the centre of mass moves on.
  void write_angular_velocity();
  /// Writes the end of the step. How the centre of mass moves stays Bullet's where it is finite.
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
  btQuaternion written_q_BW_ = btQuaternion(0, 0, 0, 0);  // of written_basis_; this one is no rotation
  // The application's, which the solver has not.
  bool uses_gyroscopic_term_ = false;
  btScalar largest_velocity_ = 0;
  btVector3 force_W_ = btVector3(0, 0, 0);
  btVector3 torque_W_ = btVector3(0, 0, 0);
  // The step under way.
  bool is_constrained_ = false;
  btVector3 given_W_ = btVector3(0, 0, 0);
  CompositeBody::Wrench cancelling_{btVector3(0, 0, 0), btVector3(0, 0, 0)};
  btVector3 given_centre_W_ = btVector3(0, 0, 0);  // of mass, from the base
  btVector3 solved_centre_velocity_ = btVector3(0, 0, 0);
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
