#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "bullet/body_readings.h"
#include "bullet/bullet_replay.h"
#include "bullet/conversions.h"
#include "bullet/non_finite.h"
#include "bullet/prefetch.h"
#include "bullet/turns_together.h"
#include "polhode/bullet/rotation_control.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Whether Bullet has turned the body in this step already.
enum class BulletsTurn {
  made,      ///< Bullet integrated; its turn is replaced
  left_out,  ///< Bullet did not see the body; it is moved on here, too
};

/// One body's step from what Bullet's solver left to what is written back.
struct PendingStep {
  // Found by prepare_step.
  BulletsTurn bullets_turn;
  bool is_in_place;  // nobody has turned it since its pose was written
  btVector3 solved_W;
  double turned_fraction;  // of dt: less than 1 where continuous collision detection stopped it
  // As the body was known, then as Bullet's turn by solved_W over dt would have it, and at last as it is to
  // be; the first two are not looked at if is_in_place.
  btMatrix3x3 basis;

  // By start_step.
  StepInput input;
  RotationState state;  // in: the start of the step; out: its end
  Quaternion start_q_WB;
  bool has_late_kick;
  Vector3 late_kick_W;

  // For write_step.
  Vector3 mean_omega_W;  // from the start to the end
};

/// What is known of a body in numbers, in the order in which a step comes to need them.
struct BodyNumbers {
  Quaternion q_WB = Quaternion::Identity();
  Vector3 omega_W = Vector3::Zero();
  // As Bullet's body said when it and the state last agreed.
  PackedVector inverse_inertia_B{};
  PackedVector origin{};
  PackedVector linear_velocity{};
  Vector3 L_W = Vector3::Zero();
};

/// One body of the world, under a scheme or not: its double state, and what Bullet's body said when the two
/// last agreed. A step walks all of them, so it is kept small: what Bullet holds of the orientation and of
/// the velocity is as a rule the state, rounded, and not kept a second time; what few bodies have is in
/// RarePart.
class ManagedBody {
 public:
  explicit ManagedBody(btRigidBody& body);
  ManagedBody(ManagedBody&&) noexcept = default;
  ManagedBody& operator=(ManagedBody&&) noexcept = default;
  ~ManagedBody() = default;

  /// Whether this is about that body and no other that had its address.
  bool is_about(const btRigidBody& body) const;
  btRigidBody* address() const { return body_; }

  /// @name What the application chose
  /// @{
  void choose_default() { choose(Choice::world_default, nullptr); }
  void choose_own(SchemePointer scheme) { choose(Choice::own_scheme, std::move(scheme)); }
  void choose_release() { choose(Choice::released, nullptr); }
  /// The scheme that should rotate the body; null: none.
  const RotationScheme* wanted(const RotationScheme* world_default) const {
    return choice_ == Choice::world_default ? world_default : chosen();
  }
  /// @}

  const RotationScheme* scheme() const { return scheme_; }
  bool is_managed() const { return scheme_ != nullptr; }
  bool keeps_rotation() const { return keeps_rotation_; }

  /// Takes the body over as it is and clears its gyroscopic flags.
  void take_on(const RotationScheme& scheme);
  /// Gives the body its gyroscopic flags back.
  void give_back();
  /// Forgets the scheme without touching the body.
  void forget_scheme();

  /// Before the solver. Takes over what the application changed; takes out what is not finite.
  void begin_step();

  /// @name For untouched_predictions.h and untouched_step.h
  /// @{
  /// What the application changed, if it did.
  void take_over_changes();
  /// Whether begin_step may find nothing to be done; begin_untouched looks closer.
  bool may_be_untouched() const { return !has_found() && !diverged_ && !is_damped(); }
  void begin_untouched(bool is_free_to_turn) {
    clear_flags();
    know_start(is_free_to_turn);
  }
  /// After the solver: whether step_untouched may stand for the body.
  bool may_be_in_place(BulletsTurn bullets_turn) const {
    if (!turns_by_solver(*body_)) return false;
    if (bullets_turn == BulletsTurn::left_out) return turns_freely_;
    return start_is_known_ && !has_found() && !diverged_ && keeps_rotation_ &&
           body_->getAngularDamping() == btScalar(0.0) &&
           body_->getCcdSquareMotionThreshold() == btScalar(0.0);
  }
  void finish_untouched() {
    ++steps_;
    clear_flags();
    if (rare_ != nullptr) forget_torque();
  }
  BodyNumbers& numbers() { return numbers_; }
  /// The columns of R_WB of a body that swells, each with a number behind it that is of no use.
  using SwollenColumns = std::array<double, 12>;
  SwollenColumns& swollen_columns() { return memory_.get<SwollenColumns>(); }
  /// @}

  /// After begin_step: whether Bullet need not move and turn the body in this step.
  bool can_leave_out_bullet() const {
    return is_managed() && !diverged_ && turns_by_solver(*body_) &&
           body_->getCcdSquareMotionThreshold() == btScalar(0.0);
  }
  /// What btDiscreteDynamicsWorld::predictUnconstraintMotion does for the body, but for the turn, which is
  /// returned.
  BasisTurn predict(btScalar dt);
  bool leaves_out_bullet() const { return leaves_out_bullet_; }
  void set_leaves_out_bullet(bool leaves_out) { leaves_out_bullet_ = leaves_out; }

  /// @name After the solver, one after the other
  /// @{
  /// False: there is no step to be taken, all is done.
  bool prepare_step(btScalar dt, BulletsTurn bullets_turn, PendingStep& pending);
  /// Fills in what the step starts from and is told.
  void start_step(btScalar dt, BulletReplay& replay, PendingStep& pending);
  /// Whether it may not turn freely about some axis; step_held then takes the scheme's step.
  bool is_held() const { return has_unturnable_axis(*body_) || has_locked_axis(*body_); }
  void step_held(PendingStep& pending);
  /// When the scheme has taken the step. False: the body has diverged and stopped; else write_step has to be
  /// called.
  bool accept_step(PendingStep& pending);
  void write_step(const PendingStep& pending);
  /// @}
  /// What the scheme is to be given: its memory of the body, or `fresh` if the body swells and its matrix is
  /// there.
  SchemeMemory& memory_of_scheme(SchemeMemory& fresh) { return keeps_rotation_ ? memory_ : fresh; }

  /// What begin_step or the last step came upon, once.
  std::optional<IncidentKind> take_incident();
  bool has_incident() const { return incident_ != 0; }
  /// Whether the handler has not heard of this kind for this body; from now on it has.
  bool is_first_report(IncidentKind kind);

  /// @name What a walk over many bodies is about to look at
  /// @{
  void prefetch_start() const { prefetch(this, &numbers_.L_W); }
  static void prefetch_start(const btRigidBody& body) { prefetch(&body, &body.getAngularFactor() + 1); }
  void prefetch_step() const { prefetch(*this); }
  static void prefetch_step(const btRigidBody& body) {
    // The poses, and whether it is active.
    prefetch(&body, reinterpret_cast<const char*>(&body) + 2 * sizeof(btCollisionObject) / 3);
    prefetch(&body.getInvInertiaTensorWorld(), &body.getAngularVelocity() + 1);
  }
  /// @}

  /// The state, with what the application changed since.
  BodyRotation rotation() const;

  /// Hands the pose to the motion state of a body that is awake, with the basis that is no rotation if the
  /// scheme keeps one.
  void show() const;

 private:
  static constexpr int kGyroscopicFlags = BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT |
                                          BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD |
                                          BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;

  enum class Choice : std::uint16_t { world_default, own_scheme, released };

  struct RarePart {
    SchemePointer own_scheme;
    Vector3 torque_W = Vector3::Zero();  // of the step before
    Vector3 torque_B = Vector3::Zero();
    // Where the body is not as the state rounded: as the application placed it, or diverged.
    bool has_found = false;
    btMatrix3x3 found_basis;
    btVector3 found_omega_W;
  };

  void choose(Choice choice, SchemePointer scheme);
  const RotationScheme* chosen() const;
  RarePart& rare();
  void read_state(RotationState& state) const;
  void set_state(const RotationState& state);
  Matrix3 swollen_R_WB() const;

  // What Bullet's body said when it and the state last agreed; always finite.
  Motion known() const;
  btMatrix3x3 known_basis() const;
  btVector3 known_omega_W() const;
  void know(const Motion& motion);
  void know_place(const btVector3& origin, const btVector3& linear_velocity);
  // Written only if it differs: a line of the cache that is written has to go back to memory.
  void know_present_place() {
    const btVector3& origin = body_->getWorldTransform().getOrigin();
    if (!same(origin, unpacked(numbers_.origin)) ||
        !same(body_->getLinearVelocity(), unpacked(numbers_.linear_velocity))) {
      know_place(origin, body_->getLinearVelocity());
    }
  }
  bool has_found() const { return rare_ != nullptr && rare_->has_found; }
  void forget_found();

  bool is_damped() const {
    return body_->getLinearDamping() != btScalar(0.0) || body_->getAngularDamping() != btScalar(0.0) ||
           has_additional_damping_;
  }
  // Written only if they differ, see know_present_place.
  void know_start(bool is_free_to_turn) {
    const bool turns_freely = is_free_to_turn && body_->getAngularDamping() == btScalar(0.0);
    if (turns_freely_ != turns_freely) turns_freely_ = turns_freely;
    if (!start_is_known_) start_is_known_ = true;
  }
  void clear_flags() {
    if ((body_->getFlags() & kGyroscopicFlags) != 0) take_flags();
  }
  void take_flags();
  bool is_as_written() const;
  bool changed_state(RotationState& state) const;
  void agree_with_omega(RotationState& state) const;
  void come_to_rest();
  bool is_where_it_was(const RotationState& state) const;
  bool needs_step(btScalar dt, BulletsTurn bullets_turn);
  bool was_placed(BulletsTurn bullets_turn) const;
  void mend_what_is_not_finite();
  void move_like_bullet(btScalar dt);
  void move(const btVector3& origin, btScalar dt, btVector3& moved) const;
  double turned_fraction(btScalar dt) const;
  void take_over_move(PendingStep& pending, btScalar dt, BulletReplay& replay) const;
  void note_torque(const RotationState& state, StepInput& input);
  void forget_torque();
  void stop_spinning();
  void write_pose(const btMatrix3x3& basis);
  void note(IncidentKind kind);

  // In the order in which a step comes to need it: what begin_step looks at first.
  btRigidBody* body_;
  const RotationScheme* scheme_ = nullptr;
  std::unique_ptr<RarePart> rare_;
  int identity_;
  std::uint16_t flags_of_application_ : 4;  // the gyroscopic ones
  Choice choice_ : 2;
  std::uint16_t reported_ : 2;  // a bit for each IncidentKind
  std::uint16_t incident_ : 2;  // 1 + IncidentKind, 0: none
  bool keeps_rotation_ : 1;
  bool start_is_known_ : 1;  // whether numbers_.omega_W is what the next solve starts from
  bool diverged_ : 1;
  bool leaves_out_bullet_ : 1;
  bool has_additional_damping_ : 1;  // of Bullet's, which only a constructor sets
  bool turns_freely_ : 1;            // in this step nothing but the solver acts on its rotation
  BodyNumbers numbers_;
  std::uint64_t steps_ = 0;
  SchemeMemory memory_;  // of the scheme; the matrix of a body that swells
};

// Each walk over the bodies of a world goes through this much memory.
static_assert(sizeof(ManagedBody) <= 376, "what few bodies have belongs into RarePart");

}  // namespace POLHODE_PRECISION
}  // namespace polhode
