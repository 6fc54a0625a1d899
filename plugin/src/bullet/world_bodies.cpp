#include "bullet/world_bodies.h"

#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "bullet/inertia_tensors.h"
#include "bullet/parallel_loop.h"
#include "bullet/prefetch.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

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

void show_pose(btRigidBody& body) {
  btMotionState* motion_state = body.getMotionState();
  if (motion_state != nullptr && body.isActive()) {
    motion_state->setWorldTransform(body.getInterpolationWorldTransform());
  }
}

constexpr int kPrefetchedAhead = 4;

void prefetch_start(const ManagedBody& entry, const btRigidBody& body) {
  entry.prefetch_start();
  ManagedBody::prefetch_start(body);
}

void prefetch_step(const ManagedBody& entry, const btRigidBody& body) {
  entry.prefetch_step();
  ManagedBody::prefetch_step(body);
}

// Also what is looked at where Bullet has turned the body.
void prefetch_whole_step(const ManagedBody& entry, const btRigidBody& body) {
  entry.prefetch_step();
  ManagedBody::prefetch_start(body);
}

// One of the application's may be of any size; the pose of Bullet's is at its start.
void prefetch_motion_state(const btRigidBody& body) {
  const btMotionState* motion_state = body.getMotionState();
  if (motion_state != nullptr) {
    prefetch(motion_state, reinterpret_cast<const char*>(motion_state) + sizeof(btTransform));
  }
}

}  // namespace

WorldBodies::WorldBodies(btDynamicsWorld& world) : world_(&require_discrete(world)) {
  require_matching_bullet();
  // Found out here, where no other thread is at work.
  turns_in_lanes();
  inertia_tensors_in_lanes();
  take_on_world();
}

void WorldBodies::require_world() const {
  if (world_ == nullptr) throw std::logic_error("the world of this RotationControl is gone");
}

void WorldBodies::take_on_world() {
  require_world();
  claim_.stake(*world_);
  settle_all();
}

void WorldBodies::leave_world() {
  if (world_ != nullptr) {
    for (int i = 0; i < bodies().size(); ++i) body_removed(*bodies()[i]);
  }
  for (std::size_t i = 0; i < table_.size(); ++i) table_[i].forget_scheme();
  claim_.give_up();
}

void WorldBodies::world_is_gone() noexcept {
  world_ = nullptr;
  table_.clear();
  claim_.give_up();
}

void WorldBodies::set_default_scheme(SchemePointer scheme) {
  const SchemePointer former = std::exchange(default_scheme_, std::move(scheme));
  settle_all();
  // Bodies that are not in the world at present must not keep a scheme that may be gone.
  for (std::size_t i = 0; i < table_.size(); ++i) {
    if (table_[i].scheme() != table_[i].wanted(default_scheme_.get())) table_[i].forget_scheme();
  }
  list_is_stale_ = true;
}

void WorldBodies::body_added(btRigidBody& body) {
  bodies_changed_ = list_is_stale_ = true;
  settle(table_.entry_of(body), body);
}

// The choice stays, for a body that is added again before the next step.
void WorldBodies::body_removed(btRigidBody& body) {
  bodies_changed_ = list_is_stale_ = true;
  if (find(body) != nullptr) table_.entry_of(body).give_back();
}

const ManagedBody* WorldBodies::find(const btRigidBody& body) const {
  const ManagedBody* entry = table_.find(body);
  return entry != nullptr && entry->is_managed() ? entry : nullptr;
}

std::size_t WorldBodies::managed_bodies() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < table_.size(); ++i) count += table_[i].is_managed() ? 1 : 0;
  return count;
}

// Calls function(entry, body, groups) for every body of the world and finish(groups) at the end of each part
// of the walk.
template <class Prefetch, class Function, class Finish>
void WorldBodies::walk(const Prefetch& prefetch_body, const Function& function, const Finish& finish) {
  if (world_ == nullptr) return;
  align_table();
  for_parts(table_.size_of(bodies()), [&](std::size_t first, std::size_t last) {
    StepGroups& groups = groups_of_this_thread();
    for (std::size_t i = first; i < last; ++i) {
      if (i + kPrefetchedAhead < last) {
        prefetch_body(table_[i + kPrefetchedAhead], *bodies()[static_cast<int>(i + kPrefetchedAhead)]);
      }
      function(table_[i], *bodies()[static_cast<int>(i)], groups);
    }
    finish(groups);
    if (groups.take_found_incidents()) has_incidents_.store(true, std::memory_order_relaxed);
  });
}

// A world of ours says when a body comes or goes; in another's it has to be looked for.
void WorldBodies::align_table() {
  if (world_tells_ && !bodies_changed_ && table_.size() == BodyTable::size_of(bodies())) return;
  table_.align(bodies());
  bodies_changed_ = false;
}

// Brings what is done with a body in line with what was chosen for it.
void WorldBodies::settle(ManagedBody& entry, btRigidBody& body) {
  const RotationScheme* wanted = entry.wanted(default_scheme_.get());
  if (entry.scheme() == wanted) return;
  if (wanted != nullptr && !entry.is_managed() && body.isStaticOrKinematicObject()) return;
  entry.give_back();
  if (wanted == nullptr) return;
  entry.take_on(*wanted);
  if (!entry.keeps_rotation()) some_swell_.store(true, std::memory_order_relaxed);
}

void WorldBodies::settle_all() {
  if (world_ == nullptr) return;
  align_table();
  for (int i = 0; i < bodies().size(); ++i) settle(table_[static_cast<std::size_t>(i)], *bodies()[i]);
}

void WorldBodies::begin_step() {
  walk(
      prefetch_start,
      [this](ManagedBody& entry, btRigidBody& body, StepGroups& groups) {
        settle(entry, body);
        begin(entry, groups);
      },
      [](StepGroups& /*groups*/) {});
  report();
}

void WorldBodies::begin(ManagedBody& entry, StepGroups& groups) {
  if (!entry.is_managed()) return;
  entry.begin_step();
  if (entry.has_incident()) groups.note_incident();
}

void WorldBodies::begin_step_and_predict(btScalar dt) {
  if (world_ == nullptr) return;
  world_tells_ = true;
  has_others_.store(false, std::memory_order_relaxed);
  // A late impulse of Bullet's wants all bodies where Bullet left them.
  const bool bullet_moves_all = world_->getApplySpeculativeContactRestitution();
  walk(
      prefetch_start,
      [this, dt, bullet_moves_all](ManagedBody& entry, btRigidBody& body, StepGroups& groups) {
        settle(entry, body);
        const bool is_own = !bullet_moves_all && entry.can_leave_out_bullet();
        // Written only if it differs: a line of the cache that is written has to go back to memory.
        if (entry.leaves_out_bullet() != is_own) entry.set_leaves_out_bullet(is_own);
        if (!is_own) has_others_.store(true, std::memory_order_relaxed);
        if (is_own) {
          groups.begin(entry, dt);
        } else {
          begin(entry, groups);
        }
      },
      [dt](StepGroups& groups) { groups.complete_predictions(dt); });
  other_bodies_.clear();
  list_is_stale_ = has_others_;
  if (report()) predict_again(dt);
}

// The handler may have moved, kicked, released or removed bodies.
void WorldBodies::predict_again(btScalar dt) {
  align_table();
  for (int i = 0; i < bodies().size(); ++i) {
    btRigidBody& body = *bodies()[i];
    if (!table_[static_cast<std::size_t>(i)].leaves_out_bullet()) continue;
    body.predictIntegratedTransform(dt, body.getInterpolationWorldTransform());
  }
}

void WorldBodies::list_other_bodies() {
  other_bodies_.clear();
  align_table();
  for (int i = 0; i < bodies().size(); ++i) {
    const ManagedBody& entry = table_[static_cast<std::size_t>(i)];
    if (!entry.leaves_out_bullet()) other_bodies_.push_back(bodies()[i]);
  }
  list_is_stale_ = false;
}

void WorldBodies::hide_own_bodies() {
  if (world_ == nullptr) return;
  if (list_is_stale_) list_other_bodies();
  hidden_.hide_all_but(other_bodies_, bodies());
}

void WorldBodies::unhide_own_bodies() {
  if (world_ != nullptr) hidden_.unhide(bodies());
}

StepGroups& WorldBodies::groups_of_this_thread() {
  static std::mutex one_at_a_time;  // a btRigidBody in there: its constructor counts bodies
  std::unique_ptr<StepGroups>& groups = groups_of_threads_[btGetCurrentThreadIndex()];
  if (groups == nullptr) {
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    groups = std::make_unique<StepGroups>();
  }
  return *groups;
}

// A box is soon computed; where there are many the step waits for their memory.
void WorldBodies::update_boxes() {
  if (world_ == nullptr) return;
  constexpr int kAhead = 2;
  const btCollisionObjectArray& objects = world_->getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    if (i + 3 * kAhead < objects.size()) {
      const auto* object = reinterpret_cast<const char*>(objects[i + 3 * kAhead]);
      prefetch(object, object + 4 * sizeof(btCollisionObject) / 5);  // the poses and what comes after
    }
    if (i + 2 * kAhead < objects.size()) {
      // Of Bullet's two broadphases this is the greater part of a body's.
      const btBroadphaseProxy* proxy = objects[i + 2 * kAhead]->getBroadphaseHandle();
      prefetch(proxy, proxy + 1);
    }
    if (world_->getForceUpdateAllAabbs() || objects[i]->isActive()) world_->updateSingleAabb(objects[i]);
  }
}

template <class Prefetch, class Choose>
void WorldBodies::rotate(btScalar dt, const Prefetch& prefetch_body, const Choose& is_chosen) {
  walk(
      prefetch_body,
      [&](ManagedBody& entry, btRigidBody& body, StepGroups& groups) {
        if (!is_chosen(entry)) return;
        if (entry.leaves_out_bullet()) {
          groups.step(entry, dt, BulletsTurn::left_out);
        } else {
          finish(entry, body, dt, groups);
        }
      },
      [](StepGroups& groups) { groups.complete_all(); });
}

void WorldBodies::finish(ManagedBody& entry, btRigidBody& body, btScalar dt, StepGroups& groups) {
  const bool was_managed = entry.is_managed();
  settle(entry, body);
  if (!entry.is_managed()) return;
  if (was_managed) {
    groups.step(entry, dt, BulletsTurn::made);
    return;
  }
  // First seen now: Bullet turned it in this step.
  begin(entry, groups);
}

void WorldBodies::finish_step(btScalar dt) {
  rotate(dt, prefetch_whole_step, [](const ManagedBody& /*entry*/) { return true; });
  end_step();
}

void WorldBodies::move_and_rotate_own_bodies(btScalar dt) {
  rotate(dt, prefetch_step, [](const ManagedBody& entry) { return entry.leaves_out_bullet(); });
}

void WorldBodies::finish_other_bodies(btScalar dt) {
  if (list_is_stale_ || !other_bodies_.empty()) {
    rotate(dt, prefetch_whole_step, [](const ManagedBody& entry) { return !entry.leaves_out_bullet(); });
  }
  end_step();
}

void WorldBodies::end_step() {
  if (world_ == nullptr) return;
  table_.forget_others(bodies());
  report();
}

void WorldBodies::show_own_bodies() {
  if (world_ == nullptr) return;
  align_table();
  constexpr int kAhead = kPrefetchedAhead;
  for (int i = 0; i < bodies().size(); ++i) {
    if (i + 2 * kAhead < bodies().size()) {
      prefetch(bodies()[i + 2 * kAhead]->getInterpolationWorldTransform());
    }
    if (i + kAhead < bodies().size()) prefetch_motion_state(*bodies()[i + kAhead]);
    // As a rule what the library keeps of a body need not be looked at.
    const ManagedBody& entry = table_[static_cast<std::size_t>(i)];
    if (!has_others_ && !some_swell_) {
      show_pose(*bodies()[i]);
    } else if (entry.leaves_out_bullet()) {
      entry.show();
    }
  }
}

void WorldBodies::show_swollen_bodies() {
  show_swollen([](const ManagedBody& /*entry*/) { return true; });
}

void WorldBodies::show_other_swollen_bodies() {
  if (has_others_) show_swollen([](const ManagedBody& entry) { return !entry.leaves_out_bullet(); });
}

template <class Choose>
void WorldBodies::show_swollen(const Choose& is_chosen) {
  if (!some_swell_ || world_ == nullptr) return;
  align_table();
  for (std::size_t i = 0; i < table_.size_of(bodies()); ++i) {
    if (table_[i].is_managed() && !table_[i].keeps_rotation() && is_chosen(table_[i])) table_[i].show();
  }
}

// When every body is done, since the handler may release, reassign or remove bodies. True if it was called.
bool WorldBodies::report() {
  if (!has_incidents_.exchange(false)) return false;
  std::vector<Incident> list;
  for (int i = 0; i < bodies().size(); ++i) {
    ManagedBody& entry = table_[static_cast<std::size_t>(i)];
    const std::optional<IncidentKind> kind = entry.take_incident();
    if (!kind) continue;
    ++incidents;
    btRigidBody& body = *bodies()[i];
    if (*kind == IncidentKind::non_finite_body) forget_contacts(*world_->getDispatcher(), body);
    if (handler && entry.is_first_report(*kind)) list.push_back({*kind, &body, entry.rotation().steps});
  }
  const IncidentHandler present_handler = handler;
  for (const Incident& incident : list) {
    try {
      present_handler(incident);
    } catch (...) {  // nothing may be thrown through Bullet's step
    }
  }
  return !list.empty();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
