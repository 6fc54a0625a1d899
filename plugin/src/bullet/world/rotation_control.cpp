#include "polhode/bullet/rotation_control.h"

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <LinearMath/btQuickprof.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "bullet/internals/private_members.h"
#include "bullet/snapshot/body_snapshot.h"
#include "bullet/snapshot/world_snapshot.h"
#include "bullet/world/world_stepper.h"
#include "polhode/rotation_limits.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

void require_turns_as_one_body(const btMultiBody& multibody) {
  if (multibody.hasFixedBase() || !is_finalized(multibody)) {
    throw std::invalid_argument(
        "this btMultiBody cannot be rotated by a scheme: its base is fixed, or finalizeMultiDof() was not "
        "called");
  }
  if (!turns_as_one_body(multibody)) {
    throw std::invalid_argument(
        "a btMultiBody with movable links cannot be rotated by a scheme: valid are multibodies without links "
        "or with fixed links only");
  }
}

btMultiBody& require_one_body(btMultiBody& multibody) {
  require_turns_as_one_body(multibody);
  return multibody;
}

// Returns the multibody of a collision object that is not a rigid body.
btMultiBody& require_multibody_of(const btCollisionObject& object) {
  const btMultiBodyLinkCollider* const collider = btMultiBodyLinkCollider::upcast(&object);
  if (collider == nullptr || collider->m_multiBody == nullptr) {
    throw std::invalid_argument(
        "this collision object cannot be rotated by a scheme: valid are btRigidBody and btMultiBody");
  }
  return require_one_body(*collider->m_multiBody);
}

// Returns the body that represents the object in SchemeChoices.
btRigidBody& require_body(WorldStepper& stepper, btCollisionObject& object) {
  if (btRigidBody* const body = btRigidBody::upcast(&object)) return *body;
  return stepper.proxy_of(require_multibody_of(object));
}

SchemePointer require_scheme(SchemePointer scheme) {
  if (scheme == nullptr) {
    throw std::invalid_argument(
        "the scheme is a null pointer: pass a scheme, or call release or clear_default_scheme");
  }
  return scheme;
}

void require_takes_rotors(const RotationScheme& scheme) {
  if (scheme.description().takes_rotors) return;
  std::string valid;
  for (const SchemePointer& known : all_schemes()) {
    if (!known->description().takes_rotors) continue;
    if (!valid.empty()) valid += ", ";
    valid += known->description().name;
  }
  throw std::invalid_argument("the scheme '" + std::string(scheme.description().name) +
                              "' takes no rotors: valid are " + valid);
}

// Returns the scheme that rotates the body.
SchemePointer require_to_be_rotated(const WorldStepper& stepper, const btRigidBody& body) {
  SchemePointer scheme = stepper.treatment_of(body).scheme;
  if (body.isStaticObject() || scheme == nullptr) {
    throw std::invalid_argument(
        "this body can have no torque law or rotors, since no scheme rotates it: valid is a body that is not "
        "static and has a scheme (set_scheme or set_default_scheme)");
  }
  return scheme;
}

void require_finite(const Vector3& v, const std::string& name) {
  if (!v.allFinite()) throw std::invalid_argument(name + " is not finite: valid are three finite numbers");
}

void set_scheme_of(WorldStepper& stepper, btRigidBody& body, SchemePointer scheme) {
  scheme = require_scheme(std::move(scheme));
  const Drive* const drive = stepper.treatment_of(body).drive;
  if (drive != nullptr && drive->has_rotors()) require_takes_rotors(*scheme);
  stepper.choose(body, std::move(scheme));
}

void set_law_of(WorldStepper& stepper, btRigidBody& body, TorqueLaw law, TorqueLawOrder order) {
  if (law == nullptr)
    throw std::invalid_argument(
        "the torque law is an empty function: pass a function, or call clear_torque_law");
  require_to_be_rotated(stepper, body);
  Drive& drive = stepper.make_drive(body);
  drive.law = std::move(law);
  drive.order = order;
  drive.last_torque.reset();
}

void clear_law_of(WorldStepper& stepper, btRigidBody& body) {
  Drive* const drive = stepper.treatment_of(body).drive;
  if (drive == nullptr) return;
  drive->law = nullptr;
  drive->last_torque.reset();
  stepper.drop_idle_drive(body);
}

void set_rotor_momentum_of(WorldStepper& stepper, btRigidBody& body, const Vector3& rotor_momentum_B,
                           RotorChange change) {
  require_finite(rotor_momentum_B, "the angular momentum of the rotors");
  require_takes_rotors(*require_to_be_rotated(stepper, body));
  stepper.make_drive(body);
  stepper.set_rotor_momentum(body, rotor_momentum_B, change);
  stepper.drop_idle_drive(body);
}

void set_rotor_torque_of(WorldStepper& stepper, btRigidBody& body, const Vector3& rotor_torque_B) {
  require_finite(rotor_torque_B, "the torque of the motors");
  require_takes_rotors(*require_to_be_rotated(stepper, body));
  stepper.make_drive(body).rotor_torque_B = rotor_torque_B;
  stepper.drop_idle_drive(body);
}

BodySettings settings(const SchemeChoices& choices, const btRigidBody& body) {
  const Treatment treatment = choices.treatment_of(body);
  BodySettings result;
  result.scheme = treatment.scheme;
  result.has_own_choice = choices.has_own_choice(body);
  if (treatment.drive == nullptr) return result;
  result.torque_law = treatment.drive->law;
  result.torque_law_order = treatment.drive->order;
  result.rotor_momentum_B = treatment.drive->rotor_momentum_B;
  result.rotor_torque_B = treatment.drive->rotor_torque_B;
  return result;
}

const BodyRegistry::Lane& require_managed(const BodyRegistry::Lane& place) {
  if (place.batch == nullptr) {
    throw std::invalid_argument(
        "this body is not rotated by the library: it was released, is static or kinematic, is not in the "
        "world, or the world has no default scheme");
  }
  return place;
}

BodyRotation rotation_at(const BodyRegistry::Lane& place) {
  require_managed(place);
  return place.batch->rotation(place.lane);
}

// Keeps the bits of a quaternion that comes from a step.
Quaternion require_orientation(const Quaternion& q_WB) {
  const double norm2 = q_WB.squaredNorm();
  if (!std::isfinite(norm2) || norm2 == 0.0)
    throw std::invalid_argument(
        "the quaternion q_WB is zero or not finite: valid is a quaternion of length 1");
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  if (std::abs(norm2 - 1.0) <= kRounding) return q_WB;
  return q_WB.normalized();
}

}  // namespace

std::string_view to_string(RotorChange change) {
  return change == RotorChange::by_motor ? "by motor" : "from outside";
}

RotationControl::RotationControl(btDynamicsWorld& world) : stepper_(std::make_unique<WorldStepper>(world)) {}

RotationControl::~RotationControl() = default;

void RotationControl::set_default_scheme(std::string_view name) {
  set_default_scheme(find_scheme(name));
}

void RotationControl::set_default_scheme(SchemePointer scheme) {
  scheme = require_scheme(std::move(scheme));
  stepper_->choices().for_each_drive_with_default_scheme([&scheme](const Drive& drive) {
    if (drive.has_rotors()) require_takes_rotors(*scheme);
  });
  stepper_->set_default_scheme(std::move(scheme));
}

void RotationControl::clear_default_scheme() {
  stepper_->set_default_scheme(nullptr);
}

SchemePointer RotationControl::default_scheme() const {
  return stepper_->choices().default_scheme;
}

void RotationControl::set_scheme(btCollisionObject& body, std::string_view name) {
  set_scheme(body, find_scheme(name));
}

void RotationControl::set_scheme(btCollisionObject& body, SchemePointer scheme) {
  btRigidBody& rotated = require_body(*stepper_, body);
  if (rotated.isStaticObject()) {
    throw std::invalid_argument("a scheme cannot rotate a static body (mass 0): valid are dynamic bodies");
  }
  set_scheme_of(*stepper_, rotated, std::move(scheme));
}

void RotationControl::set_scheme(btMultiBody& multibody, std::string_view name) {
  set_scheme(multibody, find_scheme(name));
}

void RotationControl::set_scheme(btMultiBody& multibody, SchemePointer scheme) {
  set_scheme_of(*stepper_, stepper_->proxy_of(require_one_body(multibody)), std::move(scheme));
}

void RotationControl::use_default_scheme(btCollisionObject& body) {
  stepper_->choose_default(require_body(*stepper_, body));
}

void RotationControl::use_default_scheme(btMultiBody& multibody) {
  stepper_->choose_default(stepper_->proxy_of(require_one_body(multibody)));
}

void RotationControl::release(btCollisionObject& body) {
  stepper_->choose(require_body(*stepper_, body), nullptr);
}

void RotationControl::release(btMultiBody& multibody) {
  stepper_->choose(stepper_->proxy_of(require_one_body(multibody)), nullptr);
}

BodySettings RotationControl::settings_of(const btCollisionObject& body) const {
  if (const btRigidBody* const rigid_body = btRigidBody::upcast(&body))
    return settings(stepper_->choices(), *rigid_body);
  return settings_of(require_multibody_of(body));
}

BodySettings RotationControl::settings_of(const btMultiBody& multibody) const {
  require_turns_as_one_body(multibody);
  if (const btRigidBody* const proxy = stepper_->known_proxy_of(multibody))
    return settings(stepper_->choices(), *proxy);
  BodySettings result;
  result.scheme = stepper_->choices().default_scheme;
  return result;
}

void RotationControl::set_torque_law(btCollisionObject& body, TorqueLaw law, TorqueLawOrder order) {
  set_law_of(*stepper_, require_body(*stepper_, body), std::move(law), order);
}

void RotationControl::set_torque_law(btMultiBody& multibody, TorqueLaw law, TorqueLawOrder order) {
  set_law_of(*stepper_, stepper_->proxy_of(require_one_body(multibody)), std::move(law), order);
}

void RotationControl::clear_torque_law(btCollisionObject& body) {
  clear_law_of(*stepper_, require_body(*stepper_, body));
}

void RotationControl::clear_torque_law(btMultiBody& multibody) {
  clear_law_of(*stepper_, stepper_->proxy_of(require_one_body(multibody)));
}

void RotationControl::set_rotor_momentum(btCollisionObject& body, const Vector3& rotor_momentum_B,
                                         RotorChange change) {
  if (const auto* const collider = btMultiBodyLinkCollider::upcast(&body)) {
    require_body(*stepper_, body);
    set_rotor_momentum(*collider->m_multiBody, rotor_momentum_B, change);
  } else {
    set_rotor_momentum_of(*stepper_, require_body(*stepper_, body), rotor_momentum_B, change);
  }
}

void RotationControl::set_rotor_momentum(btMultiBody& multibody, const Vector3& rotor_momentum_B,
                                         RotorChange change) {
  btRigidBody& proxy_body = stepper_->proxy_of(require_one_body(multibody));
  MultibodyProxy& proxy = MultibodyProxy::of(proxy_body);
  proxy.read();
  set_rotor_momentum_of(*stepper_, proxy_body, rotor_momentum_B, change);
  proxy.write_angular_velocity();
}

void RotationControl::set_rotor_torque(btCollisionObject& body, const Vector3& rotor_torque_B) {
  set_rotor_torque_of(*stepper_, require_body(*stepper_, body), rotor_torque_B);
}

void RotationControl::set_rotor_torque(btMultiBody& multibody, const Vector3& rotor_torque_B) {
  set_rotor_torque_of(*stepper_, stepper_->proxy_of(require_one_body(multibody)), rotor_torque_B);
}

double RotationControl::time() const {
  return stepper_->time_s;
}

void RotationControl::set_time(double time_s) {
  if (!std::isfinite(time_s))
    throw std::invalid_argument("the time is not finite: valid is a finite number of seconds");
  stepper_->time_s = time_s;
}

bool RotationControl::manages(const btRigidBody& body) const {
  return stepper_->find(body).batch != nullptr;
}

bool RotationControl::manages(const btMultiBody& multibody) const {
  return stepper_->find(multibody).batch != nullptr;
}

BodyRotation RotationControl::rotation_of(const btRigidBody& body) const {
  return rotation_at(stepper_->find(body));
}

BodyRotation RotationControl::rotation_of(const btMultiBody& multibody) const {
  return rotation_at(stepper_->find(multibody));
}

std::size_t RotationControl::managed_bodies() const {
  return stepper_->managed_bodies();
}

std::vector<btRigidBody*> RotationControl::managed_rigid_bodies() const {
  return stepper_->managed_rigid_bodies();
}

std::vector<btMultiBody*> RotationControl::managed_multibodies() const {
  return stepper_->managed_multibodies();
}

void RotationControl::set_rotation(btRigidBody& body, const Quaternion& q_WB, const Vector3& omega_W) {
  require_between_steps(*stepper_);
  const BodyRegistry::Lane place = require_managed(stepper_->find(body));
  const Quaternion unit_q_WB = require_orientation(q_WB);
  if (!(omega_W.norm() <= kMaximumAngularSpeed)) {
    throw std::invalid_argument("the angular velocity omega_W is not finite or too large: valid is at most " +
                                std::to_string(kMaximumAngularSpeed) + " rad/s");
  }
  place.batch->set_rotation(place.lane, unit_q_WB, omega_W);
}

Snapshot RotationControl::save(const btRigidBody& body) const {
  require_managed(stepper_->find(body));
  return save_body(*stepper_, const_cast<btRigidBody&>(body));
}

void RotationControl::restore(btRigidBody& body, const Snapshot& snapshot) {
  if (stepper_->is_attached() && !stepper_->is_in_world(body))
    throw std::invalid_argument(
        "this body is not in the world: call addRigidBody before restoring a snapshot");
  restore_body(*stepper_, body, snapshot);
}

Snapshot RotationControl::save_world() const {
  return polhode::save_world(*stepper_);
}

void RotationControl::restore_world(const Snapshot& snapshot) {
  polhode::restore_world(*stepper_, snapshot, order_of(stepper_->world()));
}

void RotationControl::restore_world(const Snapshot& snapshot, const WorldOrder& order) {
  polhode::restore_world(*stepper_, snapshot, order);
}

void RotationControl::set_incident_handler(IncidentHandler handler) {
  stepper_->incidents.handler =
      handler == nullptr ? nullptr : std::make_shared<const IncidentHandler>(std::move(handler));
}

std::uint64_t RotationControl::incidents() const {
  return stepper_->incidents.count;
}

void RotationControl::predict_unconstrained_motion(btScalar dt, const BulletsStage& bullet) {
  BT_PROFILE("polhode: predict");
  stepper_->predict_unconstrained_motion(dt, bullet);
}

void RotationControl::create_predictive_contacts(btScalar dt, const BulletsStage& bullet) {
  stepper_->create_predictive_contacts(dt, bullet);
}

void RotationControl::before_solve() noexcept {
  BT_PROFILE("polhode: before the solve");
  stepper_->before_solve();
}

void RotationControl::integrate_transforms(btScalar dt, const BulletsStage& bullet) {
  BT_PROFILE("polhode: integrate");
  stepper_->integrate_transforms(dt, bullet);
}

void RotationControl::after_integration(btScalar dt) noexcept {
  BT_PROFILE("polhode: after the integration");
  stepper_->after_integration(dt);
}

void RotationControl::synchronize_motion_states(const BulletsStage& bullet) {
  BT_PROFILE("polhode: synchronize motion states");
  stepper_->synchronize_motion_states(bullet);
}

void RotationControl::show_swollen_bodies() {
  stepper_->show_swollen_bodies();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
