#include "bullet/managed_body.h"

#include <utility>

#include "bullet/body_readings.h"
#include "bullet/unpublished_members.h"
#include "polhode/rotation_math.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

using ColumnsOfFour = Eigen::OuterStride<4>;

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
      leaves_out_bullet_(false),
      has_additional_damping_(has_additional_damping(body)),
      turns_freely_(false) {}

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
  numbers_.inverse_inertia_B = packed(body_->getInvInertiaDiagLocal());
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
  turns_freely_ = false;
  scheme_ = nullptr;
}

void ManagedBody::take_flags() {
  const int flags = body_->getFlags();
  flags_of_application_ = static_cast<std::uint16_t>(flags & kGyroscopicFlags);
  body_->setFlags(flags & ~kGyroscopicFlags);
}

ManagedBody::RarePart& ManagedBody::rare() {
  if (rare_ == nullptr) rare_ = std::make_unique<RarePart>();
  return *rare_;
}

void ManagedBody::read_state(RotationState& state) const {
  state.q_WB = numbers_.q_WB;
  state.R_WB = keeps_rotation_ ? numbers_.q_WB.toRotationMatrix() : swollen_R_WB();
  state.omega_W = numbers_.omega_W;
  state.L_W = numbers_.L_W;
}

void ManagedBody::set_state(const RotationState& state) {
  numbers_.q_WB = state.q_WB;
  numbers_.omega_W = state.omega_W;
  numbers_.L_W = state.L_W;
  if (!keeps_rotation_) Eigen::Map<Matrix3, 0, ColumnsOfFour>(swollen_columns().data()) = state.R_WB;
}

Matrix3 ManagedBody::swollen_R_WB() const {
  return Eigen::Map<const Matrix3, 0, ColumnsOfFour>(memory_.find<SwollenColumns>()->data());
}

btMatrix3x3 ManagedBody::known_basis() const {
  return has_found() ? rare_->found_basis : basis_of(numbers_.q_WB);
}

btVector3 ManagedBody::known_omega_W() const {
  return has_found() ? rare_->found_omega_W : to_bullet(numbers_.omega_W);
}

Motion ManagedBody::known() const {
  return {btTransform(known_basis(), unpacked(numbers_.origin)), unpacked(numbers_.linear_velocity),
          known_omega_W()};
}

void ManagedBody::know(const Motion& motion) {
  know_place(motion.pose.getOrigin(), motion.linear_velocity);
  if (same(motion.pose.getBasis(), basis_of(numbers_.q_WB)) &&
      same(motion.omega_W, to_bullet(numbers_.omega_W))) {
    forget_found();
    return;
  }
  rare().has_found = true;
  rare_->found_basis = motion.pose.getBasis();
  rare_->found_omega_W = motion.omega_W;
}

void ManagedBody::know_place(const btVector3& origin, const btVector3& linear_velocity) {
  numbers_.origin = packed(origin);
  numbers_.linear_velocity = packed(linear_velocity);
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
  know_present_place();
  know_start(!has_found() && !diverged_ && !is_held() && body_->getTotalTorque().isZero());
}

bool ManagedBody::is_as_written() const {
  return !has_found() && !diverged_ && same(body_->getAngularVelocity(), to_bullet(numbers_.omega_W)) &&
         same(body_->getInvInertiaDiagLocal(), unpacked(numbers_.inverse_inertia_B)) &&
         same(body_->getWorldTransform().getBasis(), basis_of(numbers_.q_WB));
}

BasisTurn ManagedBody::predict(btScalar dt) {
  if (is_damped()) body_->applyDamping(dt);
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
  const bool reshaped = packed(body_->getInvInertiaDiagLocal()) != numbers_.inverse_inertia_B;
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
  numbers_.inverse_inertia_B = packed(body_->getInvInertiaDiagLocal());
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

void ManagedBody::show() const {
  btMotionState* motion_state = body_->getMotionState();
  if (motion_state == nullptr || !body_->isActive()) return;
  if (keeps_rotation_) {
    motion_state->setWorldTransform(body_->getInterpolationWorldTransform());
  } else {
    motion_state->setWorldTransform(
        btTransform(to_bullet(swollen_R_WB()), body_->getWorldTransform().getOrigin()));
  }
}

BodyRotation ManagedBody::rotation() const {
  RotationState now;
  read_state(now);
  if (!diverged_ && is_finite(*body_)) changed_state(now);
  return {now, now.energy(), steps_, diverged_, scheme_->description().name};
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
