#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <optional>

#include "bullet/bullet_replay.h"
#include "bullet/non_finite.h"
#include "polhode/bullet/rotation_control.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// One body under one scheme: its double state, and what Bullet's body said when the two last agreed.
class ManagedBody {
 public:
  /// Takes the body over as it is and clears its gyroscopic flags.
  ManagedBody(btRigidBody& body, SchemePointer scheme);

  /// Gives the body its gyroscopic flags back.
  void give_back_flags();

  /// Before the solver. Takes over what the application changed; takes out what is not finite.
  std::optional<IncidentKind> begin_step();

  /// After Bullet integrated by dt. Replaces Bullet's turn by the scheme's.
  std::optional<IncidentKind> finish_step(btScalar dt, BulletReplay& replay);

  /// The state, with what the application changed since.
  BodyRotation rotation() const;

  /// Hands the basis that is no rotation, if the scheme keeps one, to the body's motion state.
  void show_swollen() const;

  const SchemePointer& scheme() const { return scheme_; }
  bool keeps_rotation() const { return keeps_rotation_; }

 private:
  void clear_flags();
  void take_over_changes();
  void agree_with_omega(RotationState& state) const;
  void come_to_rest();
  std::optional<IncidentKind> replace_turn(btScalar dt, BulletReplay& replay);
  double turned_fraction(btScalar dt) const;
  void take_over_move(const btVector3& solved_W, btScalar turn_dt, bool clamped, BulletReplay& replay);
  void start_from(const btVector3& solver_start_W);
  void note_torque(StepInput& input);
  RotationState stepped(const StepInput& input);
  void stop_spinning();
  void write_pose();
  void write(const RotationState& start, double dt);

  btRigidBody* body_;
  SchemePointer scheme_;
  RotationState state_;
  SchemeMemory memory_;
  Motion known_;  // the body where it agrees with state_; always finite
  btVector3 known_inverse_inertia_B_;
  Vector3 known_torque_W_ = Vector3::Zero();  // of the step before
  Vector3 known_torque_B_ = Vector3::Zero();
  std::uint64_t steps_ = 0;
  int flags_of_application_ = 0;  // the gyroscopic ones
  bool keeps_rotation_;
  bool start_is_known_ = false;  // whether state_.omega_W is what the next solve starts from
  bool diverged_ = false;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
