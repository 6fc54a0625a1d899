#include <algorithm>
#include <limits>

#include "bullet/body_readings.h"
#include "bullet/managed_body.h"
#include "polhode/rotation_limits.h"
#include "polhode/rotation_math.h"

// The step of one body, in the order in which it is taken.
namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// The fraction of a step at which continuous collision detection stopped a body is known to rounding only, so
// in such a step a smaller turn by somebody else cannot be told from it. rad.
constexpr double kTurnLostInClampedStep = 1e-3;

// A torque is taken to turn with the body if in body axes, and less so in the world, it is what it was a step
// before; to this, relative:
// an application forms it from Bullet's basis, in single precision known to 1e-7.
constexpr double kSameTorque = 1e-5;

// Bullet's rounding of the velocity change that a torque makes, in units in the last place of its precision.
constexpr double kRoundingOfTorque = 16.0;

// As polhode::within_limits, of which a rotation needs less.
bool within_limits(const RotationState& state, bool is_rotation) {
  if (!is_rotation) return polhode::within_limits(state);
  const double probe = 0.0 * state.q_WB.w() + 0.0 * state.q_WB.x() + 0.0 * state.q_WB.y() +
                       0.0 * state.q_WB.z() + 0.0 * state.L_W.x() + 0.0 * state.L_W.y() + 0.0 * state.L_W.z();
  return probe == 0.0 && state.omega_W.squaredNorm() <= kMaximumAngularSpeed * kMaximumAngularSpeed;
}

}  // namespace

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
  if (!same(body_->getInvInertiaDiagLocal(), unpacked(numbers_.inverse_inertia_B))) {
    numbers_.inverse_inertia_B = packed(body_->getInvInertiaDiagLocal());
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
    pending.basis = basis_of(numbers_.q_WB);
  }
  return true;
}

// Bullet stops a body that has just fallen asleep after the actions of the step: should it wake in the very
// next step, the velocity it has now is not the one it starts from.
void ManagedBody::come_to_rest() {
  if (has_found()) rare_->found_omega_W.setZero();
  numbers_.omega_W.setZero();
  numbers_.L_W.setZero();
}

// Continuous collision detection stops a body within the step and leaves a hit fraction of 0; how far it came
// shows in its position.
double ManagedBody::turned_fraction(btScalar dt) const {
  if (body_->getHitFraction() != btScalar(0.0)) return 1.0;
  const Vector3 path = to_double(body_->getInterpolationLinearVelocity()) * static_cast<double>(dt);
  if (path.isZero(0.0)) return 1.0;
  const Vector3 covered =
      to_double(body_->getWorldTransform().getOrigin()) - to_double(unpacked(numbers_.origin));
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
  write_pose(basis_of(numbers_.q_WB));
  know(motion_of(*body_));
}

void ManagedBody::write_pose(const btMatrix3x3& basis) {
  body_->setCenterOfMassTransform(btTransform(basis, body_->getWorldTransform().getOrigin()));
}

void ManagedBody::write_step(const PendingStep& pending) {
  body_->setAngularVelocity(to_bullet(numbers_.omega_W));
  write_pose(pending.basis);
  // Bullet interpolates motion states between two steps back from the pose by this velocity: with the mean
  // velocity of the step it meets the pose before.
  body_->setInterpolationAngularVelocity(to_bullet(pending.mean_omega_W));
  know_place(body_->getWorldTransform().getOrigin(), body_->getLinearVelocity());
  forget_found();
  start_is_known_ = true;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
