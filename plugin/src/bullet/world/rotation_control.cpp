#include "polhode/bullet/rotation_control.h"

#include <LinearMath/btQuickprof.h>

#include <stdexcept>
#include <utility>

#include "bullet/world/world_stepper.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

btRigidBody& require_body(btCollisionObject& object) {
  btRigidBody* body = btRigidBody::upcast(&object);
  if (body == nullptr) {
    throw std::invalid_argument(
        "only a btRigidBody can be rotated by a scheme; this collision object is none (the links of a "
        "btMultiBody "
        "are turned by their joints)");
  }
  return *body;
}

SchemePointer require_scheme(SchemePointer scheme) {
  if (scheme == nullptr) {
    throw std::invalid_argument(
        "the scheme is a null pointer: give a scheme, or use release / clear_default_scheme");
  }
  return scheme;
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
  btRigidBody& rigid_body = require_body(body);
  if (rigid_body.isStaticObject()) {
    throw std::invalid_argument(
        "a static body (mass 0) does not turn: a scheme can be set for dynamic bodies");
  }
  stepper_->choose(rigid_body, require_scheme(std::move(scheme)));
}

void RotationControl::use_default_scheme(btCollisionObject& body) {
  stepper_->choose_default(require_body(body));
}

void RotationControl::release(btCollisionObject& body) {
  stepper_->choose(require_body(body), nullptr);
}

bool RotationControl::manages(const btRigidBody& body) const {
  return stepper_->find(body).batch != nullptr;
}

BodyRotation RotationControl::rotation_of(const btRigidBody& body) const {
  const BodyRegistry::Lane place = stepper_->find(body);
  if (place.batch == nullptr) {
    throw std::invalid_argument(
        "this body is not rotated by the library: it was released, is static or kinematic, is not in the "
        "world, "
        "or the world has no default scheme");
  }
  return place.batch->rotation(place.lane);
}

std::size_t RotationControl::managed_bodies() const {
  return stepper_->managed_bodies();
}

void RotationControl::set_incident_handler(IncidentHandler handler) {
  stepper_->handler =
      handler == nullptr ? nullptr : std::make_shared<const IncidentHandler>(std::move(handler));
}

std::uint64_t RotationControl::incidents() const {
  return stepper_->incidents;
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
