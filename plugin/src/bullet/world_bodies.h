#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <array>
#include <atomic>
#include <memory>
#include <vector>

#include "bullet/body_table.h"
#include "bullet/hidden_bodies.h"
#include "bullet/step_groups.h"
#include "bullet/world_claim.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// The bodies of a world and what is done with them in a step: the engine behind RotationControl. The loops
/// over bodies run on the threads of Bullet's task scheduler, if the application has given it one; each body
/// comes out the same on any number of threads.
class WorldBodies {
 public:
  /// @throws std::invalid_argument, std::runtime_error as RotationControl's constructor.
  explicit WorldBodies(btDynamicsWorld& world);

  void take_on_world();
  void leave_world();
  void world_is_gone() noexcept;

  void set_default_scheme(SchemePointer scheme);
  /// `choose(entry)` says what the application wants for the body.
  template <class Choose>
  void choose(btRigidBody& body, const Choose& choose) {
    require_world();
    bodies_changed_ = true;
    ManagedBody& entry = table_.entry_of(body);
    entry.give_back();
    choose(entry);
    settle(entry, body);
    list_is_stale_ = true;
  }
  void body_added(btRigidBody& body);
  void body_removed(btRigidBody& body);

  /// Null if the library does not rotate it.
  const ManagedBody* find(const btRigidBody& body) const;
  std::size_t managed_bodies() const;

  /// @name See RotationControl
  /// @{
  void begin_step();
  void finish_step(btScalar dt);
  void begin_step_and_predict(btScalar dt);
  void hide_own_bodies();
  void unhide_own_bodies();
  void update_boxes();
  void move_and_rotate_own_bodies(btScalar dt);
  void finish_other_bodies(btScalar dt);
  void show_own_bodies();
  void show_swollen_bodies();
  void show_other_swollen_bodies();
  /// @}

  IncidentHandler handler;
  std::uint64_t incidents = 0;

 private:
  void require_world() const;
  BodyTable::Bodies& bodies() { return world_->getNonStaticRigidBodies(); }
  template <class Prefetch, class Function, class Finish>
  void walk(const Prefetch& prefetch_body, const Function& function, const Finish& finish);
  template <class Prefetch, class Choose>
  void rotate(btScalar dt, const Prefetch& prefetch_body, const Choose& is_chosen);
  StepGroups& groups_of_this_thread();
  static void begin(ManagedBody& entry, StepGroups& groups);
  void finish(ManagedBody& entry, btRigidBody& body, btScalar dt, StepGroups& groups);

  template <class Choose>
  void show_swollen(const Choose& is_chosen);

  void align_table();
  void settle(ManagedBody& entry, btRigidBody& body);
  void settle_all();
  void predict_again(btScalar dt);
  void list_other_bodies();
  void end_step();
  bool report();

  btDiscreteDynamicsWorld* world_;
  WorldClaim claim_;
  SchemePointer default_scheme_ = polhode::default_scheme();
  BodyTable table_;
  std::array<std::unique_ptr<StepGroups>, BT_MAX_THREAD_COUNT> groups_of_threads_;
  std::vector<btRigidBody*> other_bodies_;  // that Bullet moves itself in this step
  HiddenBodies hidden_;
  bool list_is_stale_ = true;
  bool world_tells_ = false;  // of bodies that come and go
  bool bodies_changed_ = true;
  std::atomic<bool> has_others_{false};
  std::atomic<bool> some_swell_{false};  // whether a scheme may keep a basis that is no rotation
  std::atomic<bool> has_incidents_{false};
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
