#include "bullet/managed_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bullet/conversions.h"
#include "bullet/locked_axes.h"
#include "bullet/unpublished_members.h"
#include "polhode/rotation_limits.h"
#include "polhode/rotation_math.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

constexpr int kGyroscopicFlags = BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT |
                                 BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD |
                                 BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;

// The fraction of a step at which continuous collision detection stopped a body is known to rounding only, so
// in such a step a smaller turn by somebody else cannot be told from it. rad.
constexpr double kTurnLostInClampedStep = 1e-3;

// A torque is taken to turn with the body if in body axes, and less so in the world, it is what it was a step
// before; to this, relative:
// an application forms it from Bullet's basis, in single precision known to 1e-7.
constexpr double kSameTorque = 1e-5;

// Bullet's rounding of the velocity change that a torque makes, in units in the last place of its precision.
constexpr double kRoundingOfTorque = 16.0;

// Moments in kg m^2; 0 where the body does not turn about the axis, as in btRigidBody::getLocalInertia.
Vector3 inertia_B(const btRigidBody& body) {
  const Vector3 moments = to_double(body.getInvInertiaDiagLocal()).cwiseInverse();
  if (!has_unturnable_axis(body)) return moments;
  return moments.unaryExpr([](double moment) { return std::isinf(moment) ? 0.0 : moment; });
}

// Bullet is given a rotation, of a body that swells too: it keeps contact points in the body's frame and gets
// there by a transpose, so that with a swollen basis it would lose them at once.
btMatrix3x3 basis_of(const Quaternion& q_WB) {
  return to_bullet(Matrix3(q_WB.toRotationMatrix()));
}

// As polhode::within_limits, of which a rotation needs less.
bool within_limits(const RotationState& state, bool is_rotation) {
  if (!is_rotation) return polhode::within_limits(state);
  const double probe = 0.0 * state.q_WB.w() + 0.0 * state.q_WB.x() + 0.0 * state.q_WB.y() +
                       0.0 * state.q_WB.z() + 0.0 * state.L_W.x() + 0.0 * state.L_W.y() + 0.0 * state.L_W.z();
  return probe == 0.0 && state.omega_W.squaredNorm() <= kMaximumAngularSpeed * kMaximumAngularSpeed;
}

bool turns_by_solver(const btRigidBody& body) {
  return body.isActive() && !body.isStaticOrKinematicObject();
}

}  // namespace

ManagedBody::ManagedBody(btRigidBody& body)
    : body_(&body),
      identity_(body_identity(body)),
      flags_of_application_(0),
      choice_(Choice::world_default),
      reported_(0),
      incident_(0),
      keeps_rotation_(true),
      start_is_known_(false),
      diverged_(false),
      leaves_out_bullet_(false) {}

bool ManagedBody::is_about(const btRigidBody& body) const {
  return body_ == &body && identity_ == body_identity(body);
}

void ManagedBody::choose(Choice choice, SchemePointer scheme) {
  choice_ = choice;
  reported_ = 0;
  if (scheme != nullptr || rare_ != nullptr) rare().own_scheme = std::move(scheme);
}

const RotationScheme* ManagedBody::chosen() const {
  return choice_ == Choice::own_scheme ? rare_->own_scheme.get() : nullptr;
}

void ManagedBody::take_on(const RotationScheme& scheme) {
  scheme_ = &scheme;
  keeps_rotation_ = scheme.description().rotation != Conservation::lost;
  memory_ = SchemeMemory();
  steps_ = 0;
  start_is_known_ = false;
  diverged_ = false;
  clear_flags();
  // What is not finite is taken for at rest in the world's origin; the first step mends it.
  const Motion motion = finite_motion(*body_, Motion());
  RotationState start;
  set_orientation(start, to_quaternion(motion.pose.getBasis()));
  set_omega(start, inertia_B(*body_), to_double(motion.omega_W));
  set_state(start);
  known_inverse_inertia_B_ = packed(body_->getInvInertiaDiagLocal());
  know(motion);
}

void ManagedBody::give_back() {
  if (!is_managed()) return;
  body_->setFlags(body_->getFlags() | flags_of_application_);
  forget_scheme();
}

void ManagedBody::forget_scheme() {
  flags_of_application_ = 0;
  leaves_out_bullet_ = false;
  scheme_ = nullptr;
}

void ManagedBody::clear_flags() {
  const int flags = body_->getFlags();
  if ((flags & kGyroscopicFlags) == 0) return;
  flags_of_application_ = static_cast<std::uint16_t>(flags & kGyroscopicFlags);
  body_->setFlags(flags & ~kGyroscopicFlags);
}

ManagedBody::RarePart& ManagedBody::rare() {
  if (rare_ == nullptr) rare_ = std::make_unique<RarePart>();
  return *rare_;
}

void ManagedBody::read_state(RotationState& state) const {
  state.q_WB = q_WB_;
  state.R_WB = keeps_rotation_ ? q_WB_.toRotationMatrix() : swollen_R_WB();
  state.omega_W = omega_W_;
  state.L_W = L_W_;
}

void ManagedBody::set_state(const RotationState& state) {
  q_WB_ = state.q_WB;
  omega_W_ = state.omega_W;
  L_W_ = state.L_W;
  if (!keeps_rotation_) Eigen::Map<Matrix3>(memory_.get<StoredMatrix>().data()) = state.R_WB;
}

Matrix3 ManagedBody::swollen_R_WB() const {
  SchemeMemory memory = memory_;
  return Eigen::Map<const Matrix3>(memory.get<StoredMatrix>().data());
}

btMatrix3x3 ManagedBody::known_basis() const {
  return has_found() ? rare_->found_basis : basis_of(q_WB_);
}

btVector3 ManagedBody::known_omega_W() const {
  return has_found() ? rare_->found_omega_W : to_bullet(omega_W_);
}

Motion ManagedBody::known() const {
  return {btTransform(known_basis(), unpacked(known_origin_)), unpacked(known_linear_velocity_),
          known_omega_W()};
}

void ManagedBody::know(const Motion& motion) {
  know_place(motion.pose.getOrigin(), motion.linear_velocity);
  if (same(motion.pose.getBasis(), basis_of(q_WB_)) && same(motion.omega_W, to_bullet(omega_W_))) {
    forget_found();
    return;
  }
  rare().has_found = true;
  rare_->found_basis = motion.pose.getBasis();
  rare_->found_omega_W = motion.omega_W;
}

void ManagedBody::know_place(const btVector3& origin, const btVector3& linear_velocity) {
  known_origin_ = packed(origin);
  known_linear_velocity_ = packed(linear_velocity);
}

void ManagedBody::forget_found() {
  if (!has_found()) return;
  rare_->has_found = false;
  const bool is_needed = rare_->own_scheme != nullptr || !rare_->torque_W.isZero(0.0);
  if (!is_needed) rare_.reset();
}

void ManagedBody::begin_step() {
  clear_flags();
  // The usual case first: what equals the state is finite.
  if (!is_as_written() || !are_surely_finite_but_for_basis(*body_)) {
    if (!is_finite(*body_)) {
      mend(*body_, known());
      note(IncidentKind::non_finite_body);
    }
    take_over_changes();
  }
  // Written only if they differ: a line of the cache that is written has to go back to memory.
  const btVector3& origin = body_->getWorldTransform().getOrigin();
  if (!same(origin, unpacked(known_origin_)) ||
      !same(body_->getLinearVelocity(), unpacked(known_linear_velocity_))) {
    know_place(origin, body_->getLinearVelocity());
  }
  if (!start_is_known_) start_is_known_ = true;
}

bool ManagedBody::is_as_written() const {
  return !has_found() && !diverged_ && same(body_->getAngularVelocity(), to_bullet(omega_W_)) &&
         same(body_->getInvInertiaDiagLocal(), unpacked(known_inverse_inertia_B_)) &&
         same(body_->getWorldTransform().getBasis(), basis_of(q_WB_));
}

bool ManagedBody::can_leave_out_bullet() const {
  return is_managed() && !diverged_ && turns_by_solver(*body_) &&
         body_->getCcdSquareMotionThreshold() == btScalar(0.0);
}

BasisTurn ManagedBody::predict(btScalar dt) {
  if (body_->getLinearDamping() != btScalar(0.0) || body_->getAngularDamping() != btScalar(0.0) ||
      has_additional_damping(*body_)) {
    body_->applyDamping(dt);
  }
  body_->setHitFraction(btScalar(1.0));
  move(body_->getWorldTransform().getOrigin(), dt, body_->getInterpolationWorldTransform().getOrigin());
  return {&body_->getWorldTransform().getBasis(), &body_->getAngularVelocity(),
          &body_->getInterpolationWorldTransform().getBasis()};
}

// As btTransformUtil::integrateTransform does.
void ManagedBody::move(const btVector3& origin, btScalar dt, btVector3& moved) const {
  const btVector3& velocity = body_->getLinearVelocity();
  moved.setValue(origin.x() + velocity.x() * dt, origin.y() + velocity.y() * dt,
                 origin.z() + velocity.z() * dt);
}

bool ManagedBody::changed_state(RotationState& state) const {
  const btMatrix3x3& basis = body_->getWorldTransform().getBasis();
  const bool turned = !same(basis, known_basis());
  const bool kicked = !same(body_->getAngularVelocity(), known_omega_W());
  const bool reshaped = packed(body_->getInvInertiaDiagLocal()) != known_inverse_inertia_B_;
  if (!turned && !kicked && !reshaped) return false;
  read_state(state);
  if (turned) set_orientation(state, to_quaternion(basis));
  if (kicked) state.omega_W = to_double(body_->getAngularVelocity());
  agree_with_omega(state);
  return true;
}

void ManagedBody::take_over_changes() {
  RotationState changed;
  if (diverged_ || !changed_state(changed)) return;
  set_state(changed);
  know(motion_of(*body_));
  known_inverse_inertia_B_ = packed(body_->getInvInertiaDiagLocal());
}

void ManagedBody::mend_what_is_not_finite() {
  mend(*body_, known());
  take_over_changes();
  start_is_known_ = true;
  note(IncidentKind::non_finite_body);
}

bool ManagedBody::prepare_step(btScalar dt, BulletsTurn bullets_turn, PendingStep& pending) {
  clear_flags();
  read_state(pending.state);
  pending.bullets_turn = bullets_turn;
  pending.is_in_place = bullets_turn == BulletsTurn::left_out && is_where_it_was(pending.state);
  if (!pending.is_in_place && !needs_step(dt, bullets_turn)) return false;

  // What Bullet integrated with; a later change of velocity (an action before us, speculative restitution) is
  // not part of this step's turn.
  const bool by_bullet = bullets_turn == BulletsTurn::made;
  pending.solved_W = by_bullet ? body_->getInterpolationAngularVelocity() : body_->getAngularVelocity();
  pending.turned_fraction = by_bullet ? turned_fraction(dt) : 1.0;
  if (!pending.is_in_place) pending.basis = known_basis();
  return true;
}

// Awake, finite, and nobody has turned it since its pose was written.
bool ManagedBody::is_where_it_was(const RotationState& state) const {
  return turns_by_solver(*body_) && !has_found() && keeps_rotation_ &&
         same(body_->getWorldTransform().getBasis(), to_bullet(state.R_WB)) &&
         are_surely_finite_but_for_basis(*body_);
}

// Deals with what needs none.
bool ManagedBody::needs_step(btScalar dt, BulletsTurn bullets_turn) {
  if (!is_finite(*body_)) {
    if (bullets_turn == BulletsTurn::left_out && turns_by_solver(*body_)) move_like_bullet(dt);
    mend_what_is_not_finite();
    return false;
  }
  if (diverged_) {
    know(motion_of(*body_));
    return false;
  }
  if (!turns_by_solver(*body_) || was_placed(bullets_turn)) {
    take_over_changes();
    if (body_->getActivationState() == ISLAND_SLEEPING) come_to_rest();
    start_is_known_ = true;
    return false;
  }
  return true;
}

// Somebody set a pose after Bullet had integrated, or Bullet did not integrate: there is no turn to replace.
bool ManagedBody::was_placed(BulletsTurn bullets_turn) const {
  return bullets_turn == BulletsTurn::made &&
         !same(body_->getWorldTransform().getBasis(), body_->getInterpolationWorldTransform().getBasis());
}

void ManagedBody::move_like_bullet(btScalar dt) {
  btTransform moved;
  body_->predictIntegratedTransform(dt, moved);
  body_->proceedToTransform(moved);
}

void ManagedBody::start_step(btScalar dt, BulletReplay& replay, PendingStep& pending) {
  RotationState& state = pending.state;
  StepInput& input = pending.input;
  input.inertia_B = inertia_B(*body_);
  if (!same(body_->getInvInertiaDiagLocal(), unpacked(known_inverse_inertia_B_))) {
    known_inverse_inertia_B_ = packed(body_->getInvInertiaDiagLocal());
    agree_with_omega(state);
  }
  const btVector3& solved_W = pending.solved_W;
  pending.has_late_kick = !same(body_->getAngularVelocity(), solved_W);
  if (pending.has_late_kick)
    pending.late_kick_W = to_double(body_->getAngularVelocity()) - to_double(solved_W);
  if (!pending.is_in_place) take_over_move(pending, dt, replay);

  // An action cannot see a body's very first start: it then counts as starting with what the solver left.
  const btVector3 known_W = known_omega_W();
  const btVector3 solver_start_W =
      start_is_known_ ? replay.damped(known_W, body_->getAngularDamping(), dt) : solved_W;
  if (!same(solver_start_W, known_W)) {
    // By damping, or because it is not known.
    state.omega_W += to_double(solver_start_W) - to_double(known_W);
    agree_with_omega(state);
  }

  pending.start_q_WB = state.q_WB;
  input.delta_omega_W = to_double(solved_W) - to_double(solver_start_W);
  input.dt = dt;
  input.turn_dt = dt * pending.turned_fraction;
  note_torque(state, input);
}

bool ManagedBody::accept_step(PendingStep& pending) {
  RotationState& next = pending.state;
  if (pending.has_late_kick) {
    next.omega_W += pending.late_kick_W;
    agree_with_omega(next);
  }
  if (pending.bullets_turn == BulletsTurn::left_out) {
    btVector3& origin = body_->getWorldTransform().getOrigin();
    move(origin, static_cast<btScalar>(pending.input.dt), origin);
  }
  if (!within_limits(next, keeps_rotation_)) {
    stop_spinning();
    return false;
  }
  set_state(next);
  ++steps_;
  if (keeps_rotation_) {
    to_bullet(next.R_WB, pending.basis);
  } else {
    pending.basis = basis_of(q_WB_);
  }
  return true;
}

// Sets L_W to agree with omega_W. By the same formula everywhere, so that two histories of one state give the
// same bits.
void ManagedBody::agree_with_omega(RotationState& state) const {
  if (keeps_rotation_) {
    set_omega(state, inertia_B(*body_), state.omega_W);
  } else {
    state.L_W = angular_momentum_W(state.R_WB, inertia_B(*body_), state.omega_W);
  }
}

// Bullet stops a body that has just fallen asleep after the actions of the step: should it wake in the very
// next step, the velocity it has now is not the one it starts from.
void ManagedBody::come_to_rest() {
  if (has_found()) rare_->found_omega_W.setZero();
  omega_W_.setZero();
  L_W_.setZero();
}

// Continuous collision detection stops a body within the step and leaves a hit fraction of 0; how far it came
// shows in its position.
double ManagedBody::turned_fraction(btScalar dt) const {
  if (body_->getHitFraction() != btScalar(0.0)) return 1.0;
  const Vector3 path = to_double(body_->getInterpolationLinearVelocity()) * static_cast<double>(dt);
  if (path.isZero(0.0)) return 1.0;
  const Vector3 covered =
      to_double(body_->getWorldTransform().getOrigin()) - to_double(unpacked(known_origin_));
  return std::clamp(covered.dot(path) / path.squaredNorm(), 0.0, 1.0);
}

// If Bullet's update of the pose we wrote last does not give the pose we find, somebody turned the body
// before Bullet did: the application, or the solver's split impulse. With w the pose written, e = S w what
// Bullet makes of it and f = S p the pose found, S Bullet's turn, the pose it started from is p = w (e^-1 f).
// Only then is the difference taken: in single precision it is uncertain by 1e-7 rad, and would drift if
// taken at every step.
void ManagedBody::take_over_move(PendingStep& pending, btScalar dt, BulletReplay& replay) const {
  btMatrix3x3 found = body_->getWorldTransform().getBasis();
  btMatrix3x3 expected = pending.basis;
  if (pending.bullets_turn == BulletsTurn::left_out) {
    if (same(found, expected)) return;
    // The turns that Bullet would have made: the same bits on both ways in.
    found = replay.turned(found, pending.solved_W, dt);
    expected = replay.turned(expected, pending.solved_W, dt);
  } else if (pending.turned_fraction < 1.0) {
    expected = replay.turned(expected, pending.solved_W, dt * static_cast<btScalar>(pending.turned_fraction));
  }
  if (same(found, expected)) return;
  RotationState& state = pending.state;
  const Quaternion turn_B = to_quaternion(expected).conjugate() * to_quaternion(found);
  if (pending.turned_fraction < 1.0 && logarithm(turn_B).norm() < kTurnLostInClampedStep) return;
  const Quaternion q_WB = (state.q_WB * turn_B).normalized();
  const Matrix3 R_WB = state.R_WB * turn_B.toRotationMatrix();
  set_orientation(state, q_WB);
  if (!keeps_rotation_) state.R_WB = R_WB;
  agree_with_omega(state);
}

// Tells the scheme of a torque that acted alone. Bullet keeps torques until the end of stepSimulation; one
// that the solver did not see, since it was applied after it, does not explain the change and is left out.
void ManagedBody::note_torque(const RotationState& state, StepInput& input) {
  input.torque_W.setZero();
  input.torque_turns_with_body = false;
  const btVector3& torque = body_->getTotalTorque();
  if (torque.x() == 0 && torque.y() == 0 && torque.z() == 0) {
    if (rare_ != nullptr) forget_torque();
    return;
  }
  const Vector3 torque_W = to_double(torque);
  const Vector3 torque_B = state.R_WB.transpose() * torque_W;
  RarePart& known = rare();
  const double change_in_body = (torque_B - known.torque_B).norm();
  const bool turns_with_body =
      change_in_body <= kSameTorque * torque_W.norm() && change_in_body < (torque_W - known.torque_W).norm();
  known.torque_W = torque_W;
  known.torque_B = torque_B;
  if (is_held() || input.turn_dt != input.dt) return;

  const Vector3 change_W = input.dt * (inverse_inertia_W(state.R_WB, input.inertia_B) * torque_W);
  const double largest =
      (state.omega_W + input.delta_omega_W).norm() + input.dt * torque_W.norm() / input.inertia_B.minCoeff();
  const double rounding = kRoundingOfTorque * std::numeric_limits<btScalar>::epsilon() * largest;
  if ((input.delta_omega_W - change_W).norm() > rounding) return;
  input.torque_W = torque_W;
  input.torque_turns_with_body = turns_with_body;
}

void ManagedBody::forget_torque() {
  rare_->torque_W.setZero();
  rare_->torque_B.setZero();
}

bool ManagedBody::is_held() const {
  return has_unturnable_axis(*body_) || has_locked_axis(*body_);
}

void ManagedBody::step_held(PendingStep& pending) {
  const StepInput& input = pending.input;
  RotationState& next = pending.state;
  if (has_unturnable_axis(*body_)) {
    next.omega_W += input.delta_omega_W;
    set_orientation(next, (exponential(next.omega_W * input.turn_dt) * next.q_WB).normalized());
    set_omega(next, input.inertia_B, next.omega_W);
    return;
  }
  const RotationState start = next;
  SchemeMemory fresh;
  scheme_->step_with_memory(input, next, memory_of_scheme(fresh));
  hold_locked_axes(*body_, input, start, next);
}

// A spin without bound would fling the neighbours away: the body keeps its last finite pose and stops.
void ManagedBody::stop_spinning() {
  diverged_ = true;
  note(IncidentKind::scheme_diverged);
  body_->setAngularVelocity(btVector3(0, 0, 0));
  write_pose(basis_of(q_WB_));
  know(motion_of(*body_));
}

void ManagedBody::write_pose(const btMatrix3x3& basis) {
  body_->setCenterOfMassTransform(btTransform(basis, body_->getWorldTransform().getOrigin()));
}

void ManagedBody::write_step(const PendingStep& pending) {
  body_->setAngularVelocity(to_bullet(omega_W_));
  write_pose(pending.basis);
  // Bullet interpolates motion states between two steps back from the pose by this velocity: with the mean
  // velocity of the step it meets the pose before.
  body_->setInterpolationAngularVelocity(to_bullet(pending.mean_omega_W));
  know_place(body_->getWorldTransform().getOrigin(), body_->getLinearVelocity());
  forget_found();
  start_is_known_ = true;
}

std::optional<IncidentKind> ManagedBody::take_incident() {
  if (incident_ == 0) return std::nullopt;
  const auto kind = static_cast<IncidentKind>(incident_ - 1);
  incident_ = 0;
  return kind;
}

void ManagedBody::note(IncidentKind kind) {
  incident_ = static_cast<std::uint16_t>(1 + static_cast<int>(kind)) & 3U;
}

bool ManagedBody::is_first_report(IncidentKind kind) {
  const unsigned bit = 1U << static_cast<unsigned>(kind);
  const bool first = (reported_ & bit) == 0;
  reported_ = static_cast<std::uint16_t>(reported_ | bit) & 3U;
  return first;
}

void ManagedBody::show_swollen() const {
  btMotionState* motion_state = body_->getMotionState();
  if (keeps_rotation_ || motion_state == nullptr || !body_->isActive()) return;
  motion_state->setWorldTransform(
      btTransform(to_bullet(swollen_R_WB()), body_->getWorldTransform().getOrigin()));
}

BodyRotation ManagedBody::rotation() const {
  RotationState now;
  read_state(now);
  if (!diverged_ && is_finite(*body_)) changed_state(now);
  return {now, now.energy(), steps_, diverged_, scheme_->description().name};
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
