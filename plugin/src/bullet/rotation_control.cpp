#include "polhode/bullet/rotation_control.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <array>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bullet/body_identity.h"
#include "bullet/managed_body.h"
#include "bullet/world_claim.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

enum class Choice { world_default, own_scheme, released };

// What is known of one body of the world, managed or not.
struct Entry {
  explicit Entry(int body_identity) : identity(body_identity) {}

  int identity;
  Choice choice = Choice::world_default;
  SchemePointer own_scheme;
  std::optional<ManagedBody> managed;
  std::array<bool, 2> reported = {false, false};  // by IncidentKind
  std::uint64_t seen_in_step = 0;
};

btDiscreteDynamicsWorld& require_discrete(btDynamicsWorld& world) {
  const btDynamicsWorldType type = world.getWorldType();
  if (type == BT_DISCRETE_DYNAMICS_WORLD || type == BT_SOFT_RIGID_DYNAMICS_WORLD) {
    return static_cast<btDiscreteDynamicsWorld&>(world);
  }
  throw std::invalid_argument(
      "the bodies of this kind of world cannot be rotated by a scheme (btDynamicsWorldType " +
      std::to_string(type) +
      "): valid are btDiscreteDynamicsWorld, btDiscreteDynamicsWorldMt, btSoftRigidDynamicsWorld, "
      "btMultiBodyDynamicsWorld and classes derived from them");
}

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

class RotationControl::Implementation {
 public:
  explicit Implementation(btDynamicsWorld& world) : world_(&require_discrete(world)) {
    require_matching_bullet();
    take_on_world();
  }

  void take_on_world() {
    require_world();
    claim_.stake(*world_);
    settle_all();
  }

  void leave_world() {
    for_each_body([this](btRigidBody& body) { give_back(body); });
    for (auto& [address, entry] : entries_) entry.managed.reset();
    claim_.give_up();
  }

  void world_is_gone() noexcept {
    world_ = nullptr;
    entries_.clear();
    claim_.give_up();
  }

  void set_default_scheme(SchemePointer scheme) {
    default_scheme_ = std::move(scheme);
    settle_all();
  }

  void choose(btRigidBody& body, Choice choice, SchemePointer scheme) {
    require_world();
    Entry& entry = entry_of(body);
    if (entry.managed) give_back(body);
    entry.choice = choice;
    entry.own_scheme = std::move(scheme);
    entry.reported = {false, false};
    settle(entry, body);
  }

  void body_added(btRigidBody& body) { settle(entry_of(body), body); }

  // Gives the flags back; the choice stays, for a body that is added again before the next step.
  void give_back(btRigidBody& body) {
    const auto found = entries_.find(&body);
    if (found == entries_.end() || found->second.identity != body_identity(body)) return;
    if (found->second.managed) found->second.managed->give_back_flags();
    found->second.managed.reset();
  }

  const ManagedBody* find(const btRigidBody& body) const {
    const auto found = entries_.find(&body);
    if (found == entries_.end() || found->second.identity != body_identity(body)) return nullptr;
    return found->second.managed ? &*found->second.managed : nullptr;
  }

  std::size_t managed_bodies() const {
    std::size_t count = 0;
    for (const auto& [address, entry] : entries_) count += entry.managed ? 1 : 0;
    return count;
  }

  void begin_step() {
    for_each_body([this](btRigidBody& body) {
      Entry& entry = entry_of(body);
      settle(entry, body);
      if (entry.managed) note(entry, body, entry.managed->begin_step());
    });
    report();
  }

  void finish_step(btScalar dt) {
    ++step_;
    std::size_t seen = 0;
    some_swell_ = false;
    for_each_body([&](btRigidBody& body) {
      Entry& entry = entry_of(body);
      entry.seen_in_step = step_;
      ++seen;
      finish_step(entry, body, dt);
    });
    if (seen < entries_.size()) forget_absent_bodies();
    report();
  }

  void show_swollen_bodies() {
    if (!some_swell_) return;
    for_each_body([this](btRigidBody& body) {
      if (const ManagedBody* managed = find(body)) managed->show_swollen();
    });
  }

  IncidentHandler handler;
  std::uint64_t incidents = 0;

 private:
  template <class Function>
  void for_each_body(Function function) {
    if (world_ == nullptr) return;
    btAlignedObjectArray<btRigidBody*>& bodies = world_->getNonStaticRigidBodies();
    for (int i = 0; i < bodies.size(); ++i) function(*bodies[i]);
  }

  void require_world() const {
    if (world_ == nullptr) throw std::logic_error("the world of this RotationControl is gone");
  }

  // The body's entry; a new one if the address was another body's.
  Entry& entry_of(btRigidBody& body) {
    const int identity = body_identity(body);
    const auto [found, is_new] = entries_.try_emplace(&body, identity);
    if (found->second.identity != identity) found->second = Entry(identity);
    return found->second;
  }

  // Brings what is done with a body in line with what was chosen for it.
  void settle(Entry& entry, btRigidBody& body) {
    const SchemePointer& wanted = entry.choice == Choice::own_scheme ? entry.own_scheme : default_scheme_;
    if (entry.choice == Choice::released || wanted == nullptr) {
      if (entry.managed) give_back(body);
      return;
    }
    if (entry.managed && entry.managed->scheme() == wanted) return;
    if (!entry.managed && body.isStaticOrKinematicObject()) return;
    if (entry.managed) give_back(body);
    entry.managed.emplace(body, wanted);
  }

  void settle_all() {
    for_each_body([this](btRigidBody& body) { settle(entry_of(body), body); });
  }

  void finish_step(Entry& entry, btRigidBody& body, btScalar dt) {
    const bool was_managed = entry.managed.has_value();
    settle(entry, body);
    if (!entry.managed) return;
    // A body first seen now was turned by Bullet in this step.
    const std::optional<IncidentKind> incident =
        was_managed ? entry.managed->finish_step(dt, replay_) : entry.managed->begin_step();
    if (incident == IncidentKind::non_finite_body) forget_contacts(*world_->getDispatcher(), body);
    note(entry, body, incident);
    some_swell_ = some_swell_ || !entry.managed->keeps_rotation();
  }

  void note(Entry& entry, btRigidBody& body, std::optional<IncidentKind> kind) {
    if (!kind) return;
    ++incidents;
    bool& reported = entry.reported[static_cast<std::size_t>(*kind)];
    if (reported || !handler) return;
    reported = true;
    to_report_.push_back({*kind, &body, entry.managed->rotation().steps});
  }

  // When every body is done, since the handler may release, reassign or remove bodies.
  void report() {
    if (to_report_.empty()) return;
    const std::vector<Incident> list = std::exchange(to_report_, {});
    const IncidentHandler present_handler = handler;
    for (const Incident& incident : list) {
      try {
        present_handler(incident);
      } catch (...) {  // nothing may be thrown through Bullet's step
      }
    }
  }

  void forget_absent_bodies() {
    for (auto entry = entries_.begin(); entry != entries_.end();) {
      entry = entry->second.seen_in_step == step_ ? std::next(entry) : entries_.erase(entry);
    }
  }

  btDiscreteDynamicsWorld* world_;
  WorldClaim claim_;
  SchemePointer default_scheme_ = polhode::default_scheme();
  std::unordered_map<const btRigidBody*, Entry> entries_;
  BulletReplay replay_;
  std::uint64_t step_ = 0;
  std::vector<Incident> to_report_;
  bool some_swell_ = false;  // whether a body's scheme may keep a basis that is no rotation
};

RotationControl::RotationControl(btDynamicsWorld& world)
    : implementation_(std::make_unique<Implementation>(world)) {}

RotationControl::~RotationControl() = default;

void RotationControl::set_default_scheme(std::string_view name) {
  set_default_scheme(find_scheme(name));
}

void RotationControl::set_default_scheme(SchemePointer scheme) {
  implementation_->set_default_scheme(require_scheme(std::move(scheme)));
}

void RotationControl::clear_default_scheme() {
  implementation_->set_default_scheme(nullptr);
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
  implementation_->choose(rigid_body, Choice::own_scheme, require_scheme(std::move(scheme)));
}

void RotationControl::use_default_scheme(btCollisionObject& body) {
  implementation_->choose(require_body(body), Choice::world_default, nullptr);
}

void RotationControl::release(btCollisionObject& body) {
  implementation_->choose(require_body(body), Choice::released, nullptr);
}

bool RotationControl::manages(const btRigidBody& body) const {
  return implementation_->find(body) != nullptr;
}

BodyRotation RotationControl::rotation_of(const btRigidBody& body) const {
  const ManagedBody* managed = implementation_->find(body);
  if (managed == nullptr) {
    throw std::invalid_argument(
        "this body is not rotated by the library: it was released, is static or kinematic, the world has no "
        "default scheme, or it has not been seen in the world yet");
  }
  return managed->rotation();
}

std::size_t RotationControl::managed_bodies() const {
  return implementation_->managed_bodies();
}

void RotationControl::set_incident_handler(IncidentHandler handler) {
  implementation_->handler = std::move(handler);
}

std::uint64_t RotationControl::incidents() const {
  return implementation_->incidents;
}

void RotationControl::begin_step() noexcept {
  implementation_->begin_step();
}

void RotationControl::finish_step(btScalar dt) noexcept {
  implementation_->finish_step(dt);
}

void RotationControl::show_swollen_bodies() noexcept {
  implementation_->show_swollen_bodies();
}

void RotationControl::body_added(btRigidBody& body) {
  if (!body.isStaticObject()) implementation_->body_added(body);
}

void RotationControl::body_removed(btRigidBody& body) {
  implementation_->give_back(body);
}

void RotationControl::take_on_world() {
  implementation_->take_on_world();
}

void RotationControl::leave_world() {
  implementation_->leave_world();
}

void RotationControl::world_is_gone() noexcept {
  implementation_->world_is_gone();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
