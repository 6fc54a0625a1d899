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

/// Holds the bodies of a world and runs the stages of its step; implements RotationControl. The loops over
/// batches run on the threads of Bullet's task scheduler, if the application has set one.
class WorldStepper {
 public:
  /// @throws std::invalid_argument, std::runtime_error as RotationPlugin's constructor.
  explicit WorldStepper(btDynamicsWorld& world);

  /// @name For RotationControl
  /// A function that throws std::bad_alloc changes nothing, except attach(): call detach() after it fails.
  /// @{
  void attach();
  void detach();
  void world_is_gone() noexcept;
  void set_default_scheme(SchemePointer scheme);
  void choose(btRigidBody& body, SchemePointer scheme);
  void choose_default(btRigidBody& body);
  /// Returns how the body is rotated, whether or not it is in the world.
  Treatment treatment_of(const btRigidBody& body) const { return choices_.treatment_of(body); }
  const SchemeChoices& choices() const { return choices_; }
  /// Returns the body's drive. Creates it if needed.
  Drive& make_drive(btRigidBody& body);
  /// Deletes a drive that has neither a law nor rotors.
  void drop_idle_drive(btRigidBody& body);
  /// Sets the momentum in the library's state and the velocity in Bullet's body. Requires a drive.
  void set_rotor_momentum(btRigidBody& body, const Vector3& rotor_momentum_B, RotorChange change);
  /// Returns true if the body is in the world.
  bool is_in_world(const btRigidBody& body) const;
  /// Returns a null batch if the library does not rotate the body.
  BodyRegistry::Lane find(const btRigidBody& body);
  BodyRegistry::Lane find(const btMultiBody& multibody);
  /// Does the same for any rigid body in the world's list, even if it is kinematic at present. Call after
  /// synchronize().
  BodyRegistry::Lane lane_of(const btRigidBody& body);
  /// Updates the registries to match the world's lists. Costs little if these have not changed.
  void synchronize() noexcept;
  bool is_attached() const { return world_ != nullptr && claim_.holds(); }
  /// Returns true if a body has begun its step and not ended it.
  bool is_within_step() const;
  /// Returns the body that represents the multibody in choose and choose_default.
  btRigidBody& proxy_of(btMultiBody& multibody) { return multibodies_.proxy_of(multibody).body(); }
  /// Returns null if no setting was made for the multibody and it was never seen in the world.
  const btRigidBody* known_proxy_of(const btMultiBody& multibody) const {
    return multibodies_.known_proxy_of(multibody);
  }
  std::size_t managed_bodies();
  std::vector<btRigidBody*> managed_rigid_bodies();
  std::vector<btMultiBody*> managed_multibodies();
  /// @throws std::logic_error if the world is gone.
  btDiscreteDynamicsWorld& world() const;
  double time_s = 0.0;  ///< time passed to torque laws
  /// @}

  /// @name The stages of a step, in order
  /// `bullet` runs the stage of Bullet's own class. If memory runs out, a stage leaves bodies to Bullet.
  /// @{
  using BulletsStage = std::function<void()>;
  void predict_unconstrained_motion(btScalar dt, const BulletsStage& bullet);
  void create_predictive_contacts(btScalar dt, const BulletsStage& bullet);
  void before_solve() noexcept;
  /// Runs Bullet's integration only for the bodies that the library does not integrate.
  void integrate_transforms(btScalar dt, const BulletsStage& bullet);
  /// Takes the step after Bullet has integrated all bodies.
  void after_integration(btScalar dt) noexcept;
  void synchronize_motion_states(const BulletsStage& bullet);
  /// Passes R_WB unchanged to the motion states of bodies whose scheme does not keep a rotation.
  void show_swollen_bodies();
  /// @}

  IncidentReport incidents;

 private:
  using Bodies = btAlignedObjectArray<btRigidBody*>;

  /// Calls function(index) for each body of the group that the library rotates.
  template <class Function>
  void for_each_managed(BodyGroup& group, const Function& function);
  Bodies& bodies() { return world_->getNonStaticRigidBodies(); }
  /// Allocates what a step needs, except for what each batch allocates for its first body in a joint or a
  /// contact.
  /// @throws std::bad_alloc
  void synchronize_all();
  void restart(btRigidBody& body, const SchemePointer& scheme);
  void change_drive(btRigidBody& body, Drive* drive);
  /// Returns null if memory runs out.
  BulletTurn* bullet_of_this_thread() noexcept;
  /// Calls function(batch, context) for each batch, on all threads, and prefetch_batch for the batch after
  /// it.
  template <class Prefetch, class Function>
  void for_batches(btScalar dt, const BodyGroup& group, const Prefetch& prefetch_batch,
                   const Function& function);
  /// Calls lanes = function(batch, context) for each batch, then Bullet's stage for the bodies outside these
  /// lanes. If memory runs out, only calls Bullet's stage, for all bodies, and returns false.
  template <class Prefetch, class Function>
  bool share_with_bullet(btScalar dt, const Prefetch& prefetch_batch, const Function& function,
                         const BulletsStage& bullet);
  void before_solve_of_bodies(btScalar dt) noexcept;
  void before_solve_of_multibodies(btScalar dt) noexcept;
  void forget_choices_of_gone() noexcept;
  bool apply_choices_if_possible() noexcept;
  /// Call after Bullet's last change of the bodies in a step.
  void end_step(btScalar dt);

  btDiscreteDynamicsWorld* world_;
  WorldClaim claim_;
  SchemeChoices choices_;
  BodyGroup rigid_{nullptr};
  Multibodies multibodies_;
  BodyGroup of_multibodies_{&multibodies_};
  std::array<std::unique_ptr<BulletTurn>, BT_MAX_THREAD_COUNT> bullet_of_threads_;
  BulletTurn spare_bullet_;  // shared by threads without one of their own
  std::mutex spare_mutex_;
  std::vector<int> left_to_bullet_;  // positions in the world's list, in the present stage
  // Set from all threads.
  std::atomic<bool> some_may_be_clamped_{false};
  std::atomic<bool> has_incident_{false};
  std::atomic<bool> has_replaced_bodies_{false};
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
