#include "polhode/bullet/rotation_control.h"

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <LinearMath/btQuickprof.h>

#include <stdexcept>
#include <utility>

#include "bullet/internals/private_members.h"
#include "bullet/world/world_stepper.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

btMultiBody& require_one_body(btMultiBody& multibody) {
  if (multibody.hasFixedBase() || !is_finalized(multibody)) {
    throw std::invalid_argument(
        "this btMultiBody does not turn: its base is fixed, or it has not been through finalizeMultiDof");
  }
  if (!turns_as_one_body(multibody)) {
    throw std::invalid_argument(
        "a btMultiBody with links that move cannot be rotated by a scheme: they turn each other, and Bullet "
        "turns them all; one without links, or with fixed ones only, can");
  }
  return multibody;
}

// Returns the body that stands for the object in the choices.
btRigidBody& require_body(WorldStepper& stepper, btCollisionObject& object) {
  if (btRigidBody* const body = btRigidBody::upcast(&object)) return *body;
  const btMultiBodyLinkCollider* const collider = btMultiBodyLinkCollider::upcast(&object);
  if (collider == nullptr || collider->m_multiBody == nullptr) {
    throw std::invalid_argument(
        "only a btRigidBody or a btMultiBody can be rotated by a scheme; this collision object is neither");
  }
  return stepper.proxy_of(require_one_body(*collider->m_multiBody));
}

SchemePointer require_scheme(SchemePointer scheme) {
  if (scheme == nullptr) {
    throw std::invalid_argument(
        "the scheme is a null pointer: give a scheme, or use release / clear_default_scheme");
  }
  return scheme;
}

BodyRotation require_managed(const BodyRegistry::Lane& place) {
  if (place.batch == nullptr) {
    throw std::invalid_argument(
        "this body is not rotated by the library: it was released, is static or kinematic, is not in the "
        "world, or the world has no default scheme");
  }
  return place.batch->rotation(place.lane);
}

}  // namespace

RotationControl::RotationControl(btDynamicsWorld& world) : stepper_(std::make_unique<WorldStepper>(world)) {}

RotationControl::~RotationControl() = default;

void RotationControl::set_default_scheme(std::string_view name) {
  set_default_scheme(find_scheme(name));
}

void RotationControl::set_default_scheme(SchemePointer scheme) {
  stepper_->set_default_scheme(require_scheme(std::move(scheme)));
}

void RotationControl::clear_default_scheme() {
  stepper_->set_default_scheme(nullptr);
}

void RotationControl::set_scheme(btCollisionObject& body, std::string_view name) {
  set_scheme(body, find_scheme(name));
}

void RotationControl::set_scheme(btCollisionObject& body, SchemePointer scheme) {
  btRigidBody& rotated = require_body(*stepper_, body);
  if (rotated.isStaticObject()) {
    throw std::invalid_argument(
        "a static body (mass 0) does not turn: a scheme can be set for dynamic bodies");
  }
  stepper_->choose(rotated, require_scheme(std::move(scheme)));
}

void RotationControl::set_scheme(btMultiBody& multibody, std::string_view name) {
  set_scheme(multibody, find_scheme(name));
}

void RotationControl::set_scheme(btMultiBody& multibody, SchemePointer scheme) {
  stepper_->choose(stepper_->proxy_of(require_one_body(multibody)), require_scheme(std::move(scheme)));
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

bool RotationControl::manages(const btRigidBody& body) const {
  return stepper_->find(body).batch != nullptr;
}

bool RotationControl::manages(const btMultiBody& multibody) const {
  return stepper_->find(multibody).batch != nullptr;
}

BodyRotation RotationControl::rotation_of(const btRigidBody& body) const {
  return require_managed(stepper_->find(body));
}

BodyRotation RotationControl::rotation_of(const btMultiBody& multibody) const {
  return require_managed(stepper_->find(multibody));
}

std::size_t RotationControl::managed_bodies() const {
  return stepper_->managed_bodies();
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
