#include "polhode/bullet/rotation_control.h"

#include <LinearMath/btQuickprof.h>

#include <stdexcept>
#include <utility>

#include "bullet/world_bodies.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

btRigidBody& require_body(btCollisionObject& object) {
  btRigidBody* body = btRigidBody::upcast(&object);
  if (body == nullptr) {
    throw std::invalid_argument(
        "only a btRigidBody can be rotated by a scheme; this collision object is none (the links of a "
        "btMultiBody are "
        "turned by their joints)");
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

RotationControl::RotationControl(btDynamicsWorld& world) : bodies_(std::make_unique<WorldBodies>(world)) {}

RotationControl::~RotationControl() = default;

void RotationControl::set_default_scheme(std::string_view name) {
  set_default_scheme(find_scheme(name));
}

void RotationControl::set_default_scheme(SchemePointer scheme) {
  bodies_->set_default_scheme(require_scheme(std::move(scheme)));
}

void RotationControl::clear_default_scheme() {
  bodies_->set_default_scheme(nullptr);
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
  const SchemePointer required = require_scheme(std::move(scheme));
  bodies_->choose(rigid_body, [&](ManagedBody& entry) { entry.choose_own(required); });
}

void RotationControl::use_default_scheme(btCollisionObject& body) {
  bodies_->choose(require_body(body), [](ManagedBody& entry) { entry.choose_default(); });
}

void RotationControl::release(btCollisionObject& body) {
  bodies_->choose(require_body(body), [](ManagedBody& entry) { entry.choose_release(); });
}

bool RotationControl::manages(const btRigidBody& body) const {
  return bodies_->find(body) != nullptr;
}

BodyRotation RotationControl::rotation_of(const btRigidBody& body) const {
  const ManagedBody* managed = bodies_->find(body);
  if (managed == nullptr) {
    throw std::invalid_argument(
        "this body is not rotated by the library: it was released, is static or kinematic, the world has no "
        "default scheme, or it has not been seen in the world yet");
  }
  return managed->rotation();
}

std::size_t RotationControl::managed_bodies() const {
  return bodies_->managed_bodies();
}

void RotationControl::set_incident_handler(IncidentHandler handler) {
  bodies_->handler = std::move(handler);
}

std::uint64_t RotationControl::incidents() const {
  return bodies_->incidents;
}

void RotationControl::begin_step() noexcept {
  BT_PROFILE("polhode: begin");
  bodies_->begin_step();
}

void RotationControl::finish_step(btScalar dt) noexcept {
  BT_PROFILE("polhode: rotate");
  bodies_->finish_step(dt);
}

void RotationControl::begin_step_and_predict(btScalar dt) noexcept {
  BT_PROFILE("polhode: predict");
  bodies_->begin_step_and_predict(dt);
}

void RotationControl::hide_own_bodies() {
  bodies_->hide_own_bodies();
}

void RotationControl::unhide_own_bodies() noexcept {
  bodies_->unhide_own_bodies();
}

void RotationControl::update_boxes() {
  BT_PROFILE("updateAabbs");
  bodies_->update_boxes();
}

void RotationControl::move_and_rotate_own_bodies(btScalar dt) noexcept {
  BT_PROFILE("polhode: rotate");
  bodies_->move_and_rotate_own_bodies(dt);
}

void RotationControl::finish_other_bodies(btScalar dt) noexcept {
  BT_PROFILE("polhode: rotate others");
  bodies_->finish_other_bodies(dt);
}

void RotationControl::show_own_bodies() {
  BT_PROFILE("polhode: show");
  bodies_->show_own_bodies();
}

void RotationControl::show_swollen_bodies() noexcept {
  bodies_->show_swollen_bodies();
}

void RotationControl::show_other_swollen_bodies() noexcept {
  bodies_->show_other_swollen_bodies();
}

void RotationControl::body_added(btRigidBody& body) {
  if (!body.isStaticObject()) bodies_->body_added(body);
}

void RotationControl::body_removed(btRigidBody& body) {
  bodies_->body_removed(body);
}

void RotationControl::take_on_world() {
  bodies_->take_on_world();
}

void RotationControl::leave_world() {
  bodies_->leave_world();
}

void RotationControl::world_is_gone() noexcept {
  bodies_->world_is_gone();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
