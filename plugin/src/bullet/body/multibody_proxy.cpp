#include "bullet/body/multibody_proxy.h"

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <limits>
#include <new>

#include "bullet/batch/bullet_rows.h"
#include "bullet/body/non_finite.h"
#include "bullet/internals/prefetch.h"
#include "bullet/internals/private_members.h"
#include "polhode/bullet/conversions.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

constexpr btScalar kAnyMass = 1;  // unused, since only the rotation is computed; 0 would make the body static

btQuaternion rounded(const Quaternion& q) {
  const auto number = [](double exact) { return static_cast<btScalar>(exact); };
  return {number(q.x()), number(q.y()), number(q.z()), number(q.w())};
}

btMatrix3x3 basis_of_base(const btMultiBody& multibody) {
  return btMatrix3x3(multibody.getWorldToBaseRot().inverse());
}

bool sleeps(const btMultiBodyLinkCollider* collider) {
  return collider != nullptr && collider->getActivationState() == ISLAND_SLEEPING;
}

// Bullet deactivates a collider whose bounding box is not finite.
void switch_on(btMultiBodyLinkCollider* collider) {
  if (collider != nullptr && collider->getActivationState() == DISABLE_SIMULATION)
    collider->forceActivationState(ACTIVE_TAG);
}

void move(btMultiBodyLinkCollider* collider, const btTransform& pose) {
  if (collider == nullptr) return;
  collider->setWorldTransform(pose);
  collider->setInterpolationWorldTransform(pose);
}

}  // namespace

MultibodyProxy::MultibodyProxy(btMultiBody& multibody)
    : multibody_(multibody),
      composite_(multibody),
      body_(kAnyMass, nullptr, nullptr, to_bullet(composite_.inertia_C())) {
  body_.setUserPointer(this);
  read();
}

void MultibodyProxy::prefetch() const {
  prefetch_poses(body_);
  prefetch_dynamics(body_);
  polhode::prefetch(&multibody_, &multibody_.getBaseTorque() + 1);
}

// A multibody without colliders never sleeps.
bool MultibodyProxy::is_moved_by_bullet() const {
  bool is_moved = !sleeps(multibody_.getBaseCollider());
  for (int link = 0; link < multibody_.getNumLinks(); ++link)
    is_moved &= !sleeps(multibody_.getLinkCollider(link));
  return is_moved;
}

btVector3 MultibodyProxy::centre_from_base_W() const {
  return composite_.has_links() ? basis_of_base(multibody_) * composite_.centre_B() : btVector3(0, 0, 0);
}

void MultibodyProxy::read() noexcept {
  const bool had_links = composite_.has_links();
  bool has_other_inertia = false;
  try {
    has_other_inertia = composite_.update(multibody_);
  } catch (const std::bad_alloc&) {  // more links than before: left to Bullet until memory is available
    body_.forceActivationState(DISABLE_SIMULATION);
    return;
  }
  if (has_other_inertia) {
    body_.setMassProps(kAnyMass, to_bullet(composite_.inertia_C()));
    if (had_links || composite_.has_links())
      written_q_BW_.setValue(0, 0, 0, 0);  // the principal axes have changed
  }
  const btQuaternion& q_BW = multibody_.getWorldToBaseRot();
  btTransform& pose = body_.getWorldTransform();
  if (q_BW == written_q_BW_) {
    pose.setBasis(written_basis_);
  } else {
    pose.setBasis(btMatrix3x3(q_BW.inverse()));
    if (composite_.has_links()) pose.setBasis(btMatrix3x3(q_BW.inverse() * rounded(composite_.q_BC())));
  }
  const btVector3 omega_W = multibody_.getBaseOmega();
  const btVector3 centre_W = centre_from_base_W();
  pose.setOrigin(multibody_.getBasePos() + centre_W);
  body_.setLinearVelocity(multibody_.getBaseVel() + omega_W.cross(centre_W));
  body_.setAngularVelocity(omega_W);
  total_force(body_) = multibody_.getBaseForce();
  for (int link = 0; link < multibody_.getNumLinks(); ++link)  // only to check that they are finite
    total_force(body_) += multibody_.getLinkForce(link) + multibody_.getLinkTorque(link);
  total_torque(body_) = multibody_.getBaseTorque();
  body_.forceActivationState(is_moved_by_bullet() ? ACTIVE_TAG : ISLAND_SLEEPING);
  body_.setCollisionFlags(multibody_.isBaseKinematic() ? btCollisionObject::CF_KINEMATIC_OBJECT : 0);
}

void MultibodyProxy::move_colliders() {
  const btTransform base_pose = multibody_.getBaseWorldTransform();
  move(multibody_.getBaseCollider(), base_pose);
  for (int link = 0; link < multibody_.getNumLinks(); ++link) {
    const btTransform pose = base_pose * composite_.link_pose_B(link);
    multibody_.getLink(link).m_cachedWorldTransform = pose;
    move(multibody_.getLinkCollider(link), pose);
  }
}

bool MultibodyProxy::is_multibody_finite() const {
  const btQuaternion& q = multibody_.getWorldToBaseRot();
  btVector3 forces = multibody_.getBaseForce() + multibody_.getBaseTorque();
  for (int link = 0; link < multibody_.getNumLinks(); ++link)
    forces += multibody_.getLinkForce(link) + multibody_.getLinkTorque(link);
  return are_finite(btVector3(q.x(), q.y(), q.z()) * q.w(), multibody_.getBasePos(), multibody_.getBaseVel(),
                    multibody_.getBaseOmega(), forces);
}

void MultibodyProxy::take_out_non_finite() {
  if (!is_multibody_finite() && is_finite(body_)) write_what_is_not_finite();
}

void MultibodyProxy::write_what_is_not_finite() {
  const btQuaternion& q = multibody_.getWorldToBaseRot();
  const bool is_turned_finite = are_finite(btVector3(q.x(), q.y(), q.z()), btVector3(q.w(), 0, 0));
  const bool is_placed_finite = are_finite(multibody_.getBasePos());
  if (!is_turned_finite) {
    const btQuaternion q_WC = body_.getWorldTransform().getRotation();
    multibody_.setWorldToBaseRot((q_WC * rounded(composite_.q_BC()).inverse()).inverse());
  }
  const btVector3 centre_W = centre_from_base_W();
  if (!is_placed_finite) multibody_.setBasePos(body_.getWorldTransform().getOrigin() - centre_W);
  if (!are_finite(multibody_.getBaseOmega())) multibody_.setBaseOmega(body_.getAngularVelocity());
  if (!are_finite(multibody_.getBaseVel()))
    multibody_.setBaseVel(body_.getLinearVelocity() - body_.getAngularVelocity().cross(centre_W));
  if (!are_finite(multibody_.getBaseForce())) base_force(multibody_) = body_.getTotalForce();
  if (!are_finite(multibody_.getBaseTorque())) base_torque(multibody_) = body_.getTotalTorque();
  for (int link = 0; link < multibody_.getNumLinks(); ++link) {
    if (are_finite(multibody_.getLinkForce(link), multibody_.getLinkTorque(link))) continue;
    multibody_.getLink(link).m_appliedForce.setZero();
    multibody_.getLink(link).m_appliedTorque.setZero();
  }
  if (is_turned_finite && is_placed_finite) return;
  move_colliders();
  switch_on(multibody_.getBaseCollider());
  for (int link = 0; link < multibody_.getNumLinks(); ++link) switch_on(multibody_.getLinkCollider(link));
}

void MultibodyProxy::give_to_solver(bool is_constrained) {
  take_out_non_finite();
  is_constrained_ = is_constrained;
  given_W_ = body_.getAngularVelocity();
  force_W_ = multibody_.getBaseForce();
  torque_W_ = multibody_.getBaseTorque();
  base_torque(multibody_) = body_.getTotalTorque();
  given_centre_W_ = centre_from_base_W();
  if (composite_.has_links()) give_as_composite();
  multibody_.setBaseOmega(given_W_);
  uses_gyroscopic_term_ = multibody_.getUseGyroTerm();
  multibody_.setUseGyroTerm(false);
  largest_velocity_ = multibody_.getMaxCoordinateVelocity();
  const btVector3 speeds = given_W_.absolute();
  multibody_.setMaxCoordinateVelocity(std::max(largest_velocity_, speeds[speeds.maxAxis()]));
}

void MultibodyProxy::give_as_composite() {
  const btVector3 change_W = given_W_ - multibody_.getBaseOmega();
  multibody_.setBaseVel(multibody_.getBaseVel() - change_W.cross(given_centre_W_));
  cancelling_ = composite_.cancelling(basis_of_base(multibody_), given_W_);
  base_force(multibody_) += cancelling_.force_W;
  base_torque(multibody_) += cancelling_.torque_W;
}

// Returns true if the solver has changed a free body by more than the rounding of the cancelled terms.
bool MultibodyProxy::acted(const btVector3& solved_W, btScalar dt) const {
  if (is_constrained_ || !composite_.has_links()) return true;
  const Vector3& inertia_C = composite_.inertia_C();
  const auto least_moment = static_cast<btScalar>(inertia_C.minCoeff());
  const btScalar torque =
      cancelling_.torque_W.length() + cancelling_.force_W.length() * composite_.centre_B().length();
  constexpr btScalar kRounding = 32 * std::numeric_limits<btScalar>::epsilon();
  const btScalar rounding = kRounding * (given_W_.length() + btFabs(dt) * torque / least_moment);
  return !((solved_W - given_W_).length() <= rounding);
}

void MultibodyProxy::read_solved(btScalar dt) {
  multibody_.setUseGyroTerm(uses_gyroscopic_term_);
  multibody_.setMaxCoordinateVelocity(largest_velocity_);
  base_force(multibody_) = force_W_;
  base_torque(multibody_) = torque_W_;
  const btVector3 solved_W = multibody_.getBaseOmega();
  const btVector3 turn_velocity = solved_W.cross(given_centre_W_);  // of the centre of mass about the base
  solved_centre_velocity_ = multibody_.getBaseVel() + turn_velocity;
  const btVector3 solved_centre = multibody_.getBasePos() + given_centre_W_ + dt * turn_velocity;
  // Bullet has moved the body already: keep the batch from moving it again.
  const bool is_finite = are_finite(solved_centre_velocity_);
  body_.setLinearVelocity(is_finite ? btVector3(0, 0, 0) : solved_centre_velocity_);
  body_.setAngularVelocity(acted(solved_W, dt) ? solved_W : given_W_);
  body_.getWorldTransform().setOrigin(solved_centre);
  body_.forceActivationState(is_moved_by_bullet() ? ACTIVE_TAG : ISLAND_SLEEPING);
}

// For a finite spin about the centre of mass that gives the base no finite velocity.
void MultibodyProxy::stop_turning() {
  body_.setAngularVelocity(btVector3(0, 0, 0));
  multibody_.setBaseOmega(btVector3(0, 0, 0));
  multibody_.setBaseVel(solved_centre_velocity_);
}

void MultibodyProxy::write_angular_velocity() {
  const btVector3 change_W = body_.getAngularVelocity() - multibody_.getBaseOmega();
  multibody_.setBaseVel(multibody_.getBaseVel() - change_W.cross(centre_from_base_W()));
  multibody_.setBaseOmega(body_.getAngularVelocity());
}

void MultibodyProxy::write(const Quaternion& q_WC) {
  take_out_non_finite();
  if (!are_finite(solved_centre_velocity_)) solved_centre_velocity_ = body_.getLinearVelocity();
  const Quaternion q_WB = composite_.has_links() ? Quaternion(q_WC * composite_.q_BC().conjugate()) : q_WC;
  multibody_.setWorldToBaseRot(rounded(q_WB.conjugate()));
  multibody_.setBaseOmega(body_.getAngularVelocity());
  if (composite_.has_links()) {
    const btVector3 centre_W = centre_from_base_W();
    multibody_.setBasePos(body_.getWorldTransform().getOrigin() - centre_W);
    multibody_.setBaseVel(solved_centre_velocity_ - body_.getAngularVelocity().cross(centre_W));
    if (!are_finite(multibody_.getBaseVel())) stop_turning();
  }
  move_colliders();
  written_q_BW_ = multibody_.getWorldToBaseRot();
  written_basis_ = body_.getWorldTransform().getBasis();
  interpolation_linear_velocity(body_) = solved_centre_velocity_;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
