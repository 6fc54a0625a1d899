#include "bullet/world/world_stepper.h"

#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>

#include <mutex>
#include <new>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include "bullet/batch/multibody_stages.h"
#include "bullet/batch/stages.h"
#include "bullet/body/integrated_pose.h"
#include "bullet/internals/body_list.h"
#include "bullet/internals/prefetch.h"
#include "bullet/world/parallel_loop.h"
#include "bullet/world/supported_world.h"
#include "polhode/bullet/conversions.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Long enough to hide the cost of dispatching a part to a thread, short enough to balance the load.
constexpr int kBatchesInPart = 32;

// While one batch is computed, the stages prefetch the next batch and its bodies.
void prefetch_for_prediction(const Batch& batch) {
  prefetch(&batch, &batch + 1);
  for (const btRigidBody* body : batch.bodies) {
    if (body == nullptr) continue;
    prefetch_poses(*body);
    prefetch_dynamics(*body);
  }
}

void prefetch_for_solve(const Batch& batch) {
  prefetch(&batch, &batch + 1);
  for (const btRigidBody* body : batch.bodies) {
    if (body != nullptr) prefetch_flags(*body);
  }
}

void prefetch_for_integration(const Batch& batch) {
  prefetch(&batch, &batch + 1);
  prefetch(batch.memory.get(), batch.memory.get() + batch.memory_rows());
  for (const btRigidBody* body : batch.bodies) {
    if (body == nullptr) continue;
    prefetch_poses(*body);
    prefetch_velocities(*body);
    prefetch_flags(*body);
  }
}

// Returns the lanes that continuous collision detection will not clamp in this step.
LaneBits unclamped(const Batch& batch, LaneBits lanes, const StepContext& context) {
  for (std::size_t lane = 0; lane < kLanes && batch.may_be_clamped.any(); ++lane) {
    if (batch.may_be_clamped[lane] && lanes[lane] && may_be_clamped(*batch.bodies[lane], context.dt))
      lanes.reset(lane);
  }
  return lanes;
}

}  // namespace

WorldStepper::WorldStepper(btDynamicsWorld& world) : world_(&require_supported(world)), multibodies_(world) {
  require_matching_bullet();
  attach();
}

btDiscreteDynamicsWorld& WorldStepper::world() const {
  if (world_ == nullptr) throw std::logic_error("the world of this RotationControl is gone");
  return *world_;
}

void WorldStepper::attach() {
  claim_.claim(world());
  bullet_of_this_thread();  // created here, on a thread where the application may create bodies too
  synchronize_all();
}

void WorldStepper::detach() {
  rigid_.registry.clear();
  of_multibodies_.registry.clear();
  claim_.release();
}

void WorldStepper::world_is_gone() noexcept {
  detach();
  world_ = nullptr;
  multibodies_.world_is_gone();
}

void WorldStepper::synchronize() noexcept {
  const auto follow = [this](BodyGroup& group, btRigidBody* const* first, std::size_t size) {
    if (group.registry.synchronize({first, size}, choices_)) choices_.bodies_changed();
  };
  const auto count = static_cast<std::size_t>(bodies().size());
  follow(rigid_, count == 0 ? nullptr : &bodies()[0], count);
  multibodies_.synchronize();
  follow(of_multibodies_, multibodies_.bodies().data(), multibodies_.size());
}

void WorldStepper::synchronize_all() {
  synchronize();
  if (rigid_.registry.lacks_memory() || of_multibodies_.registry.lacks_memory() ||
      multibodies_.lacks_memory())
    throw std::bad_alloc();
  rigid_.is_constrained.reserve(static_cast<std::size_t>(world_->getNumCollisionObjects()));
  of_multibodies_.is_constrained.reserve(multibodies_.size());
  left_to_bullet_.reserve(static_cast<std::size_t>(bodies().size()));
}

void WorldStepper::set_default_scheme(SchemePointer scheme) {
  world();
  if (claim_.holds()) synchronize_all();
  std::swap(choices_.default_scheme, scheme);
  if (!claim_.holds()) return;
  try {
    rigid_.registry.reserve_for_choices(choices_);
    of_multibodies_.registry.reserve_for_choices(choices_);
  } catch (...) {
    rigid_.registry.cancel_reservations();
    std::swap(choices_.default_scheme, scheme);
    throw;
  }
  rigid_.registry.adopt_choices(choices_);
  of_multibodies_.registry.adopt_choices(choices_);
}

void WorldStepper::choose(btRigidBody& body, SchemePointer scheme) {
  world();
  choices_.reserve(body);
  restart(body, scheme);
  choices_.choose(body, std::move(scheme));
}

void WorldStepper::choose_default(btRigidBody& body) {
  world();
  restart(body, choices_.default_scheme);
  choices_.choose_default(body);
}

void WorldStepper::restart(btRigidBody& body, const SchemePointer& scheme) {
  if (!claim_.holds()) return;
  synchronize_all();
  const Treatment treatment = {scheme, scheme == nullptr ? nullptr : choices_.treatment_of(body).drive};
  rigid_.registry.restart(body, treatment);
  of_multibodies_.registry.restart(body, treatment);
}

BulletTurn* WorldStepper::bullet_of_this_thread() noexcept {
  static std::mutex one_at_a_time;  // BulletTurn holds a btRigidBody, whose constructor counts bodies
  std::unique_ptr<BulletTurn>& bullet = bullet_of_threads_[btGetCurrentThreadIndex()];
  if (bullet == nullptr) {
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    make_if_null(bullet);
  }
  return bullet.get();
}

template <class Prefetch, class Function>
void WorldStepper::for_batches(btScalar dt, const BodyGroup& group, const Prefetch& prefetch_batch,
                               const Function& function) {
  const std::vector<Batch*>& batches = group.registry.batches();
  for_parts(batches.size(), kBatchesInPart, [&](std::size_t first, std::size_t last) {
    BulletTurn* const own_bullet = bullet_of_this_thread();
    std::unique_lock<std::mutex> lock(spare_mutex_, std::defer_lock);
    if (own_bullet == nullptr) lock.lock();
    const StepContext context = {dt, group.is_constrained, group.solver_takes_effective_inertia, time_s,
                                 own_bullet != nullptr ? *own_bullet : spare_bullet_};
    for (std::size_t i = first; i < last; ++i) {
      if (i + 1 < last) prefetch_batch(*batches[i + 1]);
      function(*batches[i], context);
      if (batches[i]->lanes_with_incident().any()) has_incident_ = true;
      if (batches[i]->has_replaced_bodies) has_replaced_bodies_ = true;
    }
  });
}

template <class Prefetch, class Function>
bool WorldStepper::share_with_bullet(btScalar dt, const Prefetch& prefetch_batch, const Function& function,
                                     const BulletsStage& bullet) {
  try {
    left_to_bullet_.reserve(static_cast<std::size_t>(bodies().size()));
  } catch (const std::bad_alloc&) {
    for (Batch* batch : rigid_.registry.batches()) batch->of_library = LaneBits();
    bullet();
    return false;
  }
  std::atomic<int> count{0};
  for_batches(dt, rigid_, prefetch_batch, [&](Batch& batch, const StepContext& context) {
    batch.of_library = function(batch, context);
    count.fetch_add(static_cast<int>(batch.of_library.count()), std::memory_order_relaxed);
  });
  left_to_bullet_.clear();
  for (int i = 0; i < bodies().size() && count < bodies().size(); ++i) {
    const BodyRegistry::Lane place = rigid_.registry.lane_at(static_cast<std::size_t>(i), *bodies()[i]);
    if (place.batch == nullptr || !place.batch->of_library[place.lane]) left_to_bullet_.push_back(i);
  }
  run_for(left_to_bullet_, bodies(), bullet);
  return true;
}

void WorldStepper::predict_unconstrained_motion(btScalar dt, const BulletsStage& bullet) {
  synchronize();
  some_may_be_clamped_ = false;
  const bool is_shared = share_with_bullet(
      dt, prefetch_for_prediction,
      [this](Batch& batch, const StepContext& context) {
        const LaneBits lanes = predict(batch, context);
        if (batch.may_be_clamped.any()) some_may_be_clamped_ = true;
        return lanes;
      },
      bullet);
  if (is_shared) return;
  for (Batch* batch : rigid_.registry.batches()) batch->may_be_clamped = ~LaneBits();
  some_may_be_clamped_ = true;
}

// Call right after predict_unconstrained_motion.
void WorldStepper::create_predictive_contacts(btScalar dt, const BulletsStage& bullet) {
  if (!some_may_be_clamped_) {
    run_for(left_to_bullet_, bodies(), bullet);
    return;
  }
  share_with_bullet(
      dt, prefetch_for_prediction,
      [](Batch& batch, const StepContext& context) { return unclamped(batch, batch.of_library, context); },
      bullet);
}

void WorldStepper::before_solve() noexcept {
  if (world_ == nullptr || !claim_.holds()) return;
  synchronize();
  multibodies_.forget_absent();
  forget_choices_of_gone();
  const btScalar dt = world_->getDispatchInfo().m_timeStep;
  before_solve_of_bodies(dt);
  if (multibodies_.size() > 0) before_solve_of_multibodies(dt);
}

void WorldStepper::before_solve_of_bodies(btScalar dt) noexcept {
  find_constrained_bodies(*world_, rigid_.is_constrained);
  rigid_.solver_takes_effective_inertia = world_->getConstraintSolver()->getSolverType() != BT_MLCP_SOLVER;
  has_replaced_bodies_ = rigid_.registry.has_replaced_bodies_left_to_bullet();
  for_batches(dt, rigid_, prefetch_for_solve, polhode::before_solve);
  if (has_replaced_bodies_ && apply_choices_if_possible())
    for_batches(dt, rigid_, prefetch_for_solve, polhode::before_solve);
  if (has_incident_) forget_contacts_of_sanitized(rigid_, *world_->getDispatcher());
}

void WorldStepper::before_solve_of_multibodies(btScalar dt) noexcept {
  find_constrained_multibodies(multibodies_, of_multibodies_.is_constrained);
  for_batches(dt, of_multibodies_, prefetch_multibodies, polhode::before_solve_of_multibodies);
  if (has_incident_) forget_contacts_of_sanitized(of_multibodies_, *world_->getDispatcher());
}

// If memory runs out, the next step does it.
void WorldStepper::forget_choices_of_gone() noexcept {
  if (!choices_.changed()) return;
  try {
    std::unordered_set<const btRigidBody*> present(rigid_.registry.bodies().begin(),
                                                   rigid_.registry.bodies().end());
    present.insert(multibodies_.bodies().begin(), multibodies_.bodies().end());
    choices_.keep_only([&](const btRigidBody* body) { return present.count(body) != 0; });
  } catch (const std::bad_alloc&) {
  }
}

// Until this succeeds, bodies that replaced others are left to Bullet.
bool WorldStepper::apply_choices_if_possible() noexcept {
  try {
    rigid_.registry.apply_choices(choices_);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void WorldStepper::after_integration(btScalar dt) noexcept {
  if (world_ == nullptr || !claim_.holds()) return;
  synchronize();
  for_batches(dt, rigid_, prefetch_for_integration, [](Batch& batch, const StepContext& context) {
    const LaneBits left_to_bullet = ~(batch.in_solve | batch.of_library);
    after_solve(batch, batch.in_solve, PoseIntegratedBy::bullet, context);
    sanitize_left_to_bullet(batch, left_to_bullet);
  });
  end_step(dt);
}

void WorldStepper::end_step(btScalar dt) {
  time_s += static_cast<double>(dt);
  if (multibodies_.size() > 0)
    for_batches(dt, of_multibodies_, prefetch_multibodies, after_integration_of_multibodies);
  if (!has_incident_) return;
  has_incident_ = false;
  incidents.report({&rigid_, &of_multibodies_}, *world_->getDispatcher(), [this] {
    if (claim_.holds()) synchronize();
  });
}

void WorldStepper::integrate_transforms(btScalar dt, const BulletsStage& bullet) {
  // Bullet's speculative contact restitution requires Bullet to integrate every body.
  if (world_->getApplySpeculativeContactRestitution()) {
    bullet();
    after_integration(dt);
    return;
  }
  const auto integrate = [](Batch& batch, const StepContext& context) {
    const LaneBits lanes = unclamped(batch, batch.in_solve, context);
    after_solve(batch, lanes, PoseIntegratedBy::library, context);
    return lanes;
  };
  const bool is_shared = share_with_bullet(dt, prefetch_for_integration, integrate, bullet);
  if (is_shared && left_to_bullet_.empty()) {
    end_step(dt);
  } else {
    after_integration(dt);
  }
}

void WorldStepper::synchronize_motion_states(const BulletsStage& bullet) {
  if (shows_more_than_the_step_end(*world_)) {
    bullet();
    show_swollen_bodies();
    return;
  }
  // A motion state may add or remove bodies, so the list is read again for each body.
  constexpr int kAhead = 6;
  for (int i = 0; i < bodies().size(); ++i) {
    if (i + 2 * kAhead < bodies().size()) prefetch_for_motion_state(*bodies()[i + 2 * kAhead]);
    if (i + kAhead < bodies().size()) prefetch_motion_state(*bodies()[i + kAhead]);
    btRigidBody& body = *bodies()[i];
    const BodyRegistry::Lane place = rigid_.registry.lane_at(static_cast<std::size_t>(i), body);
    if (place.batch != nullptr) {
      show(*place.batch, place.lane, body, body.getInterpolationWorldTransform());
    } else if (body.isActive()) {
      world_->synchronizeSingleMotionState(&body);
    }
  }
}

void WorldStepper::show_swollen_bodies() {
  if (world_ == nullptr || !claim_.holds()) return;
  for (int i = 0; i < bodies().size(); ++i) {
    btRigidBody& body = *bodies()[i];
    const BodyRegistry::Lane place = rigid_.registry.lane_at(static_cast<std::size_t>(i), body);
    if (place.batch != nullptr && !place.batch->keeps_rotation)
      show(*place.batch, place.lane, body, pose_to_show(*world_, body));
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
