#include "bullet/world/world_stepper.h"

#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <utility>

#include "bullet/batch/stages.h"
#include "bullet/body/integrated_pose.h"
#include "bullet/body/non_finite.h"
#include "bullet/internals/body_list.h"
#include "bullet/internals/prefetch.h"
#include "bullet/world/parallel_loop.h"
#include "polhode/bullet/conversions.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Long enough that handing a part to a thread does not show, short enough that the threads end together.
constexpr int kBatchesInPart = 32;

constexpr IncidentKind kKindsInOrder[kIncidentKinds] = {IncidentKind::non_finite_body,
                                                        IncidentKind::scheme_diverged};

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

// Each stage fetches what it needs of a batch and its bodies while the one before is computed.
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

// Returns those of the lanes that continuous collision detection will not stop in this step.
LaneBits unclamped(const Batch& batch, LaneBits lanes, const StepContext& context) {
  for (std::size_t lane = 0; lane < kLanes && batch.may_be_clamped.any(); ++lane) {
    if (batch.may_be_clamped[lane] && lanes[lane] && may_be_clamped(*batch.bodies[lane], context.dt))
      lanes.reset(lane);
  }
  return lanes;
}

// A joint's partner may stand for the world, or belong to no world.
void mark(const btCollisionObject& object, std::vector<char>& is_constrained) {
  const auto index = static_cast<std::size_t>(object.getWorldArrayIndex());
  if (object.getWorldArrayIndex() >= 0 && index < is_constrained.size()) is_constrained[index] = 1;
}

// Marks, by btCollisionObject::getWorldArrayIndex, the objects that the coming solve may constrain: those in
// an enabled joint, and those in a manifold that has contact points and is answered (a trigger's is not).
// If there is no memory for all of the marks, those at the end are missing.
void find_constrained_bodies(btDiscreteDynamicsWorld& world, std::vector<char>& is_constrained) {
  const auto wanted = static_cast<std::size_t>(world.getNumCollisionObjects());
  is_constrained.clear();
  try {
    is_constrained.reserve(wanted);
  } catch (const std::bad_alloc&) {
  }
  is_constrained.resize(std::min(wanted, is_constrained.capacity()), 0);
  btDispatcher& dispatcher = *world.getDispatcher();
  constexpr int kAhead = 8;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    if (i + kAhead < dispatcher.getNumManifolds())
      prefetch(*dispatcher.getManifoldByIndexInternal(i + kAhead));
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    if (manifold.getNumContacts() == 0) continue;
    if (!dispatcher.needsResponse(manifold.getBody0(), manifold.getBody1())) continue;
    mark(*manifold.getBody0(), is_constrained);
    mark(*manifold.getBody1(), is_constrained);
  }
  for (int i = 0; i < world.getNumConstraints(); ++i) {
    const btTypedConstraint& joint = *world.getConstraint(i);
    if (!joint.isEnabled()) continue;
    mark(joint.getRigidBodyA(), is_constrained);
    mark(joint.getRigidBodyB(), is_constrained);
  }
}

}  // namespace

WorldStepper::WorldStepper(btDynamicsWorld& world) : world_(&require_discrete(world)) {
  require_matching_bullet();
  attach();
}

btDiscreteDynamicsWorld& WorldStepper::world() const {
  if (world_ == nullptr) throw std::logic_error("the world of this RotationControl is gone");
  return *world_;
}

void WorldStepper::attach() {
  claim_.claim(world());
  bullet_of_this_thread();  // made here, where the application may make bodies too
  synchronize_all();
}

void WorldStepper::detach() {
  registry_.clear();
  claim_.release();
}

void WorldStepper::world_is_gone() noexcept {
  detach();
  world_ = nullptr;
}

void WorldStepper::synchronize() noexcept {
  if (registry_.synchronize(bodies(), choices_)) choices_.bodies_changed();
}

void WorldStepper::synchronize_all() {
  synchronize();
  if (registry_.lacks_memory()) throw std::bad_alloc();
  is_constrained_.reserve(static_cast<std::size_t>(world_->getNumCollisionObjects()));
  left_to_bullet_.reserve(static_cast<std::size_t>(bodies().size()));
}

void WorldStepper::set_default_scheme(SchemePointer scheme) {
  world();
  if (claim_.holds()) synchronize_all();
  std::swap(choices_.default_scheme, scheme);
  if (!claim_.holds()) return;
  try {
    registry_.apply_choices(choices_);
  } catch (...) {
    std::swap(choices_.default_scheme, scheme);
    throw;
  }
}

void WorldStepper::choose(btRigidBody& body, SchemePointer scheme) {
  world();
  choices_.expect(body);
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
  registry_.restart(body, scheme);
}

BodyRegistry::Lane WorldStepper::find(const btRigidBody& body) {
  if (world_ == nullptr || !claim_.holds() || body.isStaticOrKinematicObject()) return {nullptr, 0};
  const int index = body.getWorldArrayIndex();
  const btCollisionObjectArray& objects = world_->getCollisionObjectArray();
  const bool is_in_world = index >= 0 && index < objects.size() && objects[index] == &body;
  if (!is_in_world) return {nullptr, 0};
  const BodyRegistry::Lane known = registry_.find(body, choices_);
  if (known.batch != nullptr) return known;
  synchronize();
  return registry_.find(body, choices_);
}

std::size_t WorldStepper::managed_bodies() {
  if (world_ == nullptr || !claim_.holds()) return 0;
  synchronize();
  std::size_t count = 0;
  for (std::size_t i = 0; i < registry_.bodies().size(); ++i) {
    count +=
        registry_.lane_at(i).batch != nullptr && !registry_.bodies()[i]->isStaticOrKinematicObject() ? 1 : 0;
  }
  return count;
}

BulletTurn* WorldStepper::bullet_of_this_thread() noexcept {
  static std::mutex one_at_a_time;  // a btRigidBody in there: its constructor counts bodies
  std::unique_ptr<BulletTurn>& bullet = bullet_of_threads_[btGetCurrentThreadIndex()];
  if (bullet == nullptr) {
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    make_if_null(bullet);
  }
  return bullet.get();
}

template <class Prefetch, class Function>
void WorldStepper::for_batches(btScalar dt, const Prefetch& prefetch_batch, const Function& function) {
  const bool takes_effective_inertia = world_->getConstraintSolver()->getSolverType() != BT_MLCP_SOLVER;
  const std::vector<Batch*>& batches = registry_.batches();
  for_parts(batches.size(), kBatchesInPart, [&](std::size_t first, std::size_t last) {
    BulletTurn* const own_bullet = bullet_of_this_thread();
    std::unique_lock<std::mutex> lock(spare_mutex_, std::defer_lock);
    if (own_bullet == nullptr) lock.lock();
    const StepContext context = {dt, is_constrained_, takes_effective_inertia,
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
    for (Batch* batch : registry_.batches()) batch->of_library = LaneBits();
    bullet();
    return false;
  }
  std::atomic<int> count{0};
  for_batches(dt, prefetch_batch, [&](Batch& batch, const StepContext& context) {
    batch.of_library = function(batch, context);
    count.fetch_add(static_cast<int>(batch.of_library.count()), std::memory_order_relaxed);
  });
  left_to_bullet_.clear();
  for (int i = 0; i < bodies().size() && count < bodies().size(); ++i) {
    const BodyRegistry::Lane place = registry_.lane_at(static_cast<std::size_t>(i), *bodies()[i]);
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
  for (Batch* batch : registry_.batches()) batch->may_be_clamped = ~LaneBits();
  some_may_be_clamped_ = true;
}

// Right after predict_unconstrained_motion.
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
  forget_choices_of_gone();
  find_constrained_bodies(*world_, is_constrained_);
  const btScalar dt = world_->getDispatchInfo().m_timeStep;
  const auto before_solve_of = [](Batch& batch, const StepContext& context) {
    polhode::before_solve(batch, context);
  };
  has_replaced_bodies_ = registry_.has_replaced_bodies_left_to_bullet();
  for_batches(dt, prefetch_for_solve, before_solve_of);
  if (has_replaced_bodies_ && apply_choices_if_possible())
    for_batches(dt, prefetch_for_solve, before_solve_of);
  forget_contacts_of_sanitized();
}

// The next step will do as well.
void WorldStepper::forget_choices_of_gone() noexcept {
  if (!choices_.changed()) return;
  try {
    const std::unordered_set<const btRigidBody*> present(registry_.bodies().begin(),
                                                         registry_.bodies().end());
    choices_.keep_only([&](const btRigidBody* body) { return present.count(body) != 0; });
  } catch (const std::bad_alloc&) {
  }
}

// Bodies that have replaced others are left to Bullet until it is.
bool WorldStepper::apply_choices_if_possible() noexcept {
  try {
    registry_.apply_choices(choices_);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void WorldStepper::after_integration(btScalar dt) noexcept {
  if (world_ == nullptr || !claim_.holds()) return;
  synchronize();
  for_batches(dt, prefetch_for_integration, [](Batch& batch, const StepContext& context) {
    const LaneBits left_to_bullet = ~(batch.in_solve | batch.of_library);
    after_solve(batch, batch.in_solve, PoseIntegratedBy::bullet, context);
    sanitize_left_to_bullet(batch, left_to_bullet);
  });
  report();
}

void WorldStepper::integrate_transforms(btScalar dt, const BulletsStage& bullet) {
  // Bullet's speculative contact restitution wants to integrate every body itself.
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
    report();
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
  // A motion state may add or remove bodies: nothing is assumed of the list from one body to the next.
  constexpr int kAhead = 6;
  for (int i = 0; i < bodies().size(); ++i) {
    if (i + 2 * kAhead < bodies().size()) prefetch_for_motion_state(*bodies()[i + 2 * kAhead]);
    if (i + kAhead < bodies().size()) prefetch_motion_state(*bodies()[i + kAhead]);
    btRigidBody& body = *bodies()[i];
    const BodyRegistry::Lane place = registry_.lane_at(static_cast<std::size_t>(i), body);
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
    const BodyRegistry::Lane place = registry_.lane_at(static_cast<std::size_t>(i), body);
    if (place.batch != nullptr && !place.batch->keeps_rotation)
      show(*place.batch, place.lane, body, pose_to_show(*world_, body));
  }
}

// Collision detection went by where such a body was: its contacts may hold numbers that are not finite.
void WorldStepper::forget_contacts_of_sanitized() {
  for (std::size_t i = 0; i < registry_.bodies().size() && has_incident_; ++i) {
    const BodyRegistry::Lane place = registry_.lane_at(i);
    if (place.batch != nullptr && place.batch->lanes_with_incident()[place.lane])
      forget_contacts(*world_->getDispatcher(), *registry_.bodies()[i]);
  }
}

// When every body is done, since the handler may release, reassign or remove bodies.
void WorldStepper::report() {
  if (!has_incident_) return;
  has_incident_ = false;
  for (std::size_t i = 0; i < registry_.bodies().size(); ++i) {
    const BodyRegistry::Lane place = registry_.lane_at(i);
    if (place.batch == nullptr) continue;
    for (const IncidentKind kind : kKindsInOrder) {
      LaneBits& to_report = place.batch->to_report[static_cast<std::size_t>(kind)];
      const LaneBits& reported = place.batch->reported[static_cast<std::size_t>(kind)];
      if (!to_report[place.lane]) continue;
      ++incidents;
      if (kind == IncidentKind::non_finite_body)
        forget_contacts(*world_->getDispatcher(), *registry_.bodies()[i]);
      if (handler == nullptr || reported[place.lane]) to_report.reset(place.lane);
    }
  }
  if (handler != nullptr) tell_handler();
}

// Goes through the bodies themselves: a list of the incidents would take memory.
void WorldStepper::tell_handler() {
  const std::shared_ptr<const IncidentHandler> present_handler = handler;
  for (std::size_t i = 0; i < registry_.bodies().size();) {
    const std::uint64_t changes = registry_.changes();
    for (const IncidentKind kind : kKindsInOrder) {
      if (registry_.changes() == changes) tell_of(i, kind, *present_handler);
    }
    i = registry_.changes() == changes ? i + 1 : 0;  // other bodies may have taken the places before
  }
}

void WorldStepper::tell_of(std::size_t index, IncidentKind kind, const IncidentHandler& present_handler) {
  const BodyRegistry::Lane place = registry_.lane_at(index);
  if (place.batch == nullptr || registry_.is_replaced(index)) return;
  LaneBits& to_report = place.batch->to_report[static_cast<std::size_t>(kind)];
  if (!to_report[place.lane]) return;
  to_report.reset(place.lane);
  place.batch->reported[static_cast<std::size_t>(kind)].set(place.lane);
  try {
    present_handler({kind, registry_.bodies()[index], place.batch->steps[place.lane]});
  } catch (...) {  // nothing may be thrown through Bullet's step
  }
  // The handler may have taken bodies out of the world, and deleted them, or detached the plugin.
  if (claim_.holds()) synchronize();
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
