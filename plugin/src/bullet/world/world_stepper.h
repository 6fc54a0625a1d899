#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "bullet/batch/step_context.h"
#include "bullet/world/body_group.h"
#include "bullet/world/incident_report.h"
#include "bullet/world/multibodies.h"
#include "bullet/world/world_claim.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// The bodies of a world and the stages of its step: the engine behind RotationControl. The loops over
/// batches run on the threads of Bullet's task scheduler, if the application has given it one.
class WorldStepper {
 public:
  /// @throws std::invalid_argument, std::runtime_error as RotationPlugin's constructor.
  explicit WorldStepper(btDynamicsWorld& world);

  /// @name For RotationControl
  /// A function that throws std::bad_alloc changes nothing, but call detach() after a failed attach().
  /// @{
  void attach();
  void detach();
  void world_is_gone() noexcept;
  void set_default_scheme(SchemePointer scheme);
  void choose(btRigidBody& body, SchemePointer scheme);
  void choose_default(btRigidBody& body);
  /// How the body is rotated, in the world or not.
  Treatment treatment_of(const btRigidBody& body) const { return choices_.treatment_of(body); }
  const SchemeChoices& choices() const { return choices_; }
  /// What drives the body, made if nothing does.
  Drive& make_drive(btRigidBody& body);
  /// Forgets a drive that has nothing left to do.
  void drop_idle_drive(btRigidBody& body);
  /// For a body that has a drive. The motion changes in the library's numbers and in Bullet's.
  void set_rotor_momentum(btRigidBody& body, const Vector3& rotor_momentum_B, RotorChange change);
  /// Returns whether the body is in the world at present.
  bool is_in_world(const btRigidBody& body) const;
  /// Batch null: the library does not rotate the body.
  BodyRegistry::Lane find(const btRigidBody& body);
  BodyRegistry::Lane find(const btMultiBody& multibody);
  /// The same for any rigid body in the world's list, also one that is kinematic at present. To be called
  /// after synchronize.
  BodyRegistry::Lane lane_of(const btRigidBody& body);
  /// Follows the world's lists. Cheap where they are as they were.
  void synchronize() noexcept;
  bool is_attached() const { return world_ != nullptr && claim_.holds(); }
  /// Returns whether some body has begun its step and not ended it.
  bool is_within_step() const;
  /// The body that stands for it in choose and choose_default.
  btRigidBody& proxy_of(btMultiBody& multibody) { return multibodies_.proxy_of(multibody).body(); }
  /// Null if nothing was chosen for the multibody and it was not seen in the world.
  const btRigidBody* known_proxy_of(const btMultiBody& multibody) const {
    return multibodies_.known_proxy_of(multibody);
  }
  std::size_t managed_bodies();
  std::vector<btRigidBody*> managed_rigid_bodies();
  std::vector<btMultiBody*> managed_multibodies();
  /// @throws std::logic_error if the world is gone.
  btDiscreteDynamicsWorld& world() const;
  double time_s = 0.0;  ///< of torque laws
  /// @}

  /// @name The stages of a step, in order
  /// `bullet` is what Bullet's own class does in the stage. Where memory is short they leave to Bullet what
  /// they cannot do.
  /// @{
  using BulletsStage = std::function<void()>;
  void predict_unconstrained_motion(btScalar dt, const BulletsStage& bullet);
  void create_predictive_contacts(btScalar dt, const BulletsStage& bullet);
  void before_solve() noexcept;
  /// Bullet integrates only the bodies that the library does not.
  void integrate_transforms(btScalar dt, const BulletsStage& bullet);
  /// Where Bullet integrated them all.
  void after_integration(btScalar dt) noexcept;
  void synchronize_motion_states(const BulletsStage& bullet);
  /// Hands the R_WB of bodies whose scheme does not keep a rotation to their motion states as it is.
  void show_swollen_bodies();
  /// @}

  IncidentReport incidents;

 private:
  using Bodies = btAlignedObjectArray<btRigidBody*>;

  /// Calls function(index) for each body of the group that the library rotates.
  template <class Function>
  void for_each_managed(BodyGroup& group, const Function& function);
  Bodies& bodies() { return world_->getNonStaticRigidBodies(); }
  /// Takes the memory that a step of all these bodies wants, but for what the first one in a joint or a
  /// contact takes.
  /// @throws std::bad_alloc
  void synchronize_all();
  void restart(btRigidBody& body, const SchemePointer& scheme);
  void change_drive(btRigidBody& body, Drive* drive);
  /// Null if there is no memory for one.
  BulletTurn* bullet_of_this_thread() noexcept;
  /// function(batch, context) for each batch, on all threads; prefetch_batch(batch) for the next one.
  template <class Prefetch, class Function>
  void for_batches(btScalar dt, const BodyGroup& group, const Prefetch& prefetch_batch,
                   const Function& function);
  /// lanes = function(batch, context) are the library's in this stage: Bullet's loop skips their bodies.
  /// Returns false if function was not called, for want of memory: then Bullet's loop runs over all bodies.
  template <class Prefetch, class Function>
  bool share_with_bullet(btScalar dt, const Prefetch& prefetch_batch, const Function& function,
                         const BulletsStage& bullet);
  void before_solve_of_bodies(btScalar dt) noexcept;
  void before_solve_of_multibodies(btScalar dt) noexcept;
  void forget_choices_of_gone() noexcept;
  bool apply_choices_if_possible() noexcept;
  /// After everything that Bullet does to the bodies.
  void end_step(btScalar dt);

  btDiscreteDynamicsWorld* world_;
  WorldClaim claim_;
  SchemeChoices choices_;
  BodyGroup rigid_{nullptr};
  Multibodies multibodies_;
  BodyGroup of_multibodies_{&multibodies_};
  std::array<std::unique_ptr<BulletTurn>, BT_MAX_THREAD_COUNT> bullet_of_threads_;
  BulletTurn spare_bullet_;  // of threads that have none, one at a time
  std::mutex spare_mutex_;
  std::vector<int> left_to_bullet_;  // places in the world's list, in the present stage
  // Set from all threads.
  std::atomic<bool> some_may_be_clamped_{false};
  std::atomic<bool> has_incident_{false};
  std::atomic<bool> has_replaced_bodies_{false};
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
