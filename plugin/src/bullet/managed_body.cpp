#include "bullet/managed_body.h"

#include <algorithm>
#include <limits>

#include "bullet/conversions.h"
#include "bullet/locked_axes.h"
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
  return to_double(body.getInvInertiaDiagLocal()).unaryExpr([](double inverse) {
    return inverse == 0.0 ? 0.0 : 1.0 / inverse;
  });
}

Motion motion_of(const btRigidBody& body) {
  return {body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity()};
}

bool turns_by_solver(const btRigidBody& body) {
  return body.isActive() && !body.isStaticOrKinematicObject();
}

}  // namespace

ManagedBody::ManagedBody(btRigidBody& body, SchemePointer scheme)
    : body_(&body),
      scheme_(std::move(scheme)),
      known_inverse_inertia_B_(body.getInvInertiaDiagLocal()),
      keeps_rotation_(scheme_->description().rotation != Conservation::lost) {
  clear_flags();
  // What is not finite is taken for at rest in the world's origin; the first step mends it.
  known_ = finite_motion(body, Motion());
  set_orientation(state_, to_quaternion(known_.pose.getBasis()));
  set_omega(state_, inertia_B(body), to_double(known_.omega_W));
}

void ManagedBody::clear_flags() {
  const int flags = body_->getFlags();
  if ((flags & kGyroscopicFlags) == 0) return;
  flags_of_application_ = flags & kGyroscopicFlags;
  body_->setFlags(flags & ~kGyroscopicFlags);
}

void ManagedBody::give_back_flags() {
  body_->setFlags(body_->getFlags() | flags_of_application_);
}

std::optional<IncidentKind> ManagedBody::begin_step() {
  clear_flags();
  const bool finite = is_finite(*body_);
  if (!finite) mend(*body_, known_);
  take_over_changes();
  known_.pose.setOrigin(body_->getWorldTransform().getOrigin());
  known_.linear_velocity = body_->getLinearVelocity();
  start_is_known_ = true;
  return finite ? std::nullopt : std::make_optional(IncidentKind::non_finite_body);
}

void ManagedBody::take_over_changes() {
  if (diverged_) return;
  const btMatrix3x3& basis = body_->getWorldTransform().getBasis();
  const bool turned = !same(basis, known_.pose.getBasis());
  const bool kicked = !same(body_->getAngularVelocity(), known_.omega_W);
  const bool reshaped = !same(body_->getInvInertiaDiagLocal(), known_inverse_inertia_B_);
  if (!turned && !kicked && !reshaped) return;
  if (turned) set_orientation(state_, to_quaternion(basis));
  if (kicked) state_.omega_W = to_double(body_->getAngularVelocity());
  agree_with_omega(state_);
  known_ = motion_of(*body_);
  known_inverse_inertia_B_ = body_->getInvInertiaDiagLocal();
}

std::optional<IncidentKind> ManagedBody::finish_step(btScalar dt, BulletReplay& replay) {
  clear_flags();
  if (!is_finite(*body_)) {
    mend(*body_, known_);
    take_over_changes();
    start_is_known_ = true;
    return IncidentKind::non_finite_body;
  }
  if (diverged_) {
    known_ = motion_of(*body_);
    return std::nullopt;
  }
  // Somebody set a pose after Bullet had integrated, or Bullet did not integrate: there is no turn to
  // replace.
  const bool placed =
      !same(body_->getWorldTransform().getBasis(), body_->getInterpolationWorldTransform().getBasis());
  if (!turns_by_solver(*body_) || placed) {
    take_over_changes();
    if (body_->getActivationState() == ISLAND_SLEEPING) come_to_rest();
    start_is_known_ = true;
    return std::nullopt;
  }
  return replace_turn(dt, replay);
}

std::optional<IncidentKind> ManagedBody::replace_turn(btScalar dt, BulletReplay& replay) {
  if (!same(body_->getInvInertiaDiagLocal(), known_inverse_inertia_B_)) {
    known_inverse_inertia_B_ = body_->getInvInertiaDiagLocal();
    agree_with_omega(state_);
  }

  // What Bullet integrated with; a later change of velocity (an action before us, speculative restitution) is
  // not part of this step's turn.
  const btVector3 solved_W = body_->getInterpolationAngularVelocity();
  const Vector3 late_kick_W = to_double(body_->getAngularVelocity()) - to_double(solved_W);
  const double fraction = turned_fraction(dt);
  take_over_move(solved_W, dt * static_cast<btScalar>(fraction), fraction < 1.0, replay);

  // An action cannot see a body's very first start: it then counts as starting with what the solver left.
  const btVector3 solver_start_W =
      start_is_known_ ? replay.damped(known_.omega_W, body_->getAngularDamping(), dt) : solved_W;
  start_from(solver_start_W);

  const RotationState start = state_;
  StepInput input{inertia_B(*body_), to_double(solved_W) - to_double(solver_start_W), dt, dt * fraction};
  note_torque(input);
  RotationState next = stepped(input);
  if (!late_kick_W.isZero(0.0)) {
    next.omega_W += late_kick_W;
    agree_with_omega(next);
  }
  if (!within_limits(next)) {
    stop_spinning();
    return IncidentKind::scheme_diverged;
  }
  state_ = next;
  ++steps_;
  write(start, dt);
  return std::nullopt;
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
  known_.omega_W.setZero();
  state_.omega_W.setZero();
  state_.L_W.setZero();
}

// Continuous collision detection stops a body within the step and leaves a hit fraction of 0; how far it came
// shows in its position.
double ManagedBody::turned_fraction(btScalar dt) const {
  if (body_->getHitFraction() != btScalar(0.0)) return 1.0;
  const Vector3 path = to_double(body_->getInterpolationLinearVelocity()) * static_cast<double>(dt);
  if (path.isZero(0.0)) return 1.0;
  const Vector3 covered =
      to_double(body_->getWorldTransform().getOrigin()) - to_double(known_.pose.getOrigin());
  return std::clamp(covered.dot(path) / path.squaredNorm(), 0.0, 1.0);
}

// If Bullet's update of the pose we wrote last does not give the pose we find, somebody turned the body
// before Bullet did: the application, or the solver's split impulse. With w the pose written, e = S w what
// Bullet makes of it and f = S p the pose found, S Bullet's turn, the pose it started from is p = w (e^-1 f).
// Only then is the difference taken: in single precision it is uncertain by 1e-7 rad, and would drift if
// taken at every step.
void ManagedBody::take_over_move(const btVector3& solved_W, btScalar turn_dt, bool clamped,
                                 BulletReplay& replay) {
  const btMatrix3x3& found = body_->getWorldTransform().getBasis();
  const btMatrix3x3 expected = replay.turned(known_.pose.getBasis(), solved_W, turn_dt);
  if (same(found, expected)) return;
  const Quaternion turn_B = to_quaternion(expected).conjugate() * to_quaternion(found);
  if (clamped && logarithm(turn_B).norm() < kTurnLostInClampedStep) return;
  const Quaternion q_WB = (state_.q_WB * turn_B).normalized();
  const Matrix3 R_WB = state_.R_WB * turn_B.toRotationMatrix();
  set_orientation(state_, q_WB);
  if (!keeps_rotation_) state_.R_WB = R_WB;
  agree_with_omega(state_);
}

// The velocity the solver starts from differs from the one written last by damping, or is not known.
void ManagedBody::start_from(const btVector3& solver_start_W) {
  if (same(solver_start_W, known_.omega_W)) return;
  state_.omega_W += to_double(solver_start_W) - to_double(known_.omega_W);
  agree_with_omega(state_);
}

// Tells the scheme of a torque that acted alone. Bullet keeps torques until the end of stepSimulation; one
// that the solver did not see, since it was applied after it, does not explain the change and is left out.
void ManagedBody::note_torque(StepInput& input) {
  const Vector3 torque_W = to_double(body_->getTotalTorque());
  if (torque_W.isZero(0.0)) {
    known_torque_W_.setZero();
    known_torque_B_.setZero();
    return;
  }
  const Vector3 torque_B = state_.R_WB.transpose() * torque_W;
  const double change_in_body = (torque_B - known_torque_B_).norm();
  const bool turns_with_body =
      change_in_body <= kSameTorque * torque_W.norm() && change_in_body < (torque_W - known_torque_W_).norm();
  known_torque_W_ = torque_W;
  known_torque_B_ = torque_B;
  if (has_unturnable_axis(*body_) || has_locked_axis(*body_) || input.turn_dt != input.dt) return;

  const Vector3 change_W = input.dt * (inverse_inertia_W(state_.R_WB, input.inertia_B) * torque_W);
  const double largest =
      (state_.omega_W + input.delta_omega_W).norm() + input.dt * torque_W.norm() / input.inertia_B.minCoeff();
  const double rounding = kRoundingOfTorque * std::numeric_limits<btScalar>::epsilon() * largest;
  if ((input.delta_omega_W - change_W).norm() > rounding) return;
  input.torque_W = torque_W;
  input.torque_turns_with_body = turns_with_body;
}

RotationState ManagedBody::stepped(const StepInput& input) {
  RotationState next = state_;
  if (has_unturnable_axis(*body_)) {
    next.omega_W += input.delta_omega_W;
    set_orientation(next, (exponential(next.omega_W * input.turn_dt) * next.q_WB).normalized());
    set_omega(next, input.inertia_B, next.omega_W);
    return next;
  }
  scheme_->step_with_memory(input, next, memory_);
  if (has_locked_axis(*body_)) hold_locked_axes(*body_, input, state_, next);
  return next;
}

// A spin without bound would fling the neighbours away: the body keeps its last finite pose and stops.
void ManagedBody::stop_spinning() {
  diverged_ = true;
  body_->setAngularVelocity(btVector3(0, 0, 0));
  write_pose();
  known_ = motion_of(*body_);
}

// A rotation, of a body that swells too: Bullet keeps contact points in the body's frame and gets there by a
// transpose, so that with a swollen basis it would lose them at once.
void ManagedBody::write_pose() {
  const Matrix3 rotation = keeps_rotation_ ? state_.R_WB : state_.q_WB.toRotationMatrix();
  body_->setCenterOfMassTransform(btTransform(to_bullet(rotation), body_->getWorldTransform().getOrigin()));
}

void ManagedBody::write(const RotationState& start, double dt) {
  body_->setAngularVelocity(to_bullet(state_.omega_W));
  write_pose();
  // Bullet interpolates motion states between two steps back from the pose by this velocity: with the mean
  // velocity of the step it meets the pose before.
  const Vector3 mean_omega_W = logarithm(state_.q_WB * start.q_WB.conjugate()) / dt;
  body_->setInterpolationAngularVelocity(to_bullet(mean_omega_W));
  known_ = motion_of(*body_);
  start_is_known_ = true;
}

void ManagedBody::show_swollen() const {
  btMotionState* motion_state = body_->getMotionState();
  if (keeps_rotation_ || motion_state == nullptr || !body_->isActive()) return;
  motion_state->setWorldTransform(
      btTransform(to_bullet(state_.R_WB), body_->getWorldTransform().getOrigin()));
}

BodyRotation ManagedBody::rotation() const {
  ManagedBody now = *this;
  if (is_finite(*body_)) now.take_over_changes();
  return {now.state_, now.state_.energy(), steps_, diverged_, scheme_->description().name};
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
