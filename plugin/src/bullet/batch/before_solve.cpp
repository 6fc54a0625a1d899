#include "bullet/batch/before_solve.h"

#include "bullet/batch/scheme_step.h"
#include "bullet/body/external_changes.h"
#include "bullet/body/locked_axes.h"
#include "bullet/body/non_finite.h"
#include "math/mean_angular_velocity.h"
#include "simd/instruction_sets.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

constexpr int kGyroscopicFlags = BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT |
                                 BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD |
                                 BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;

struct Found {
  LaneBits changed;  // by somebody else since the library last wrote the body, in more than its velocity
  LaneBits kicked;   // in its velocity
  LaneBits finite;
  LaneBits held;
};

POLHODE_FOR_EACH_INSTRUCTION_SET
void compare_with_written(const BodyPointers& bodies, const LaneBits& lanes, Batch& batch,
                          Found& found) noexcept {
  BulletDifferences differences;
  add_differences(gather_basis(bodies, basis), to_bullet(Matrix3Wide(batch.q_WB.toRotationMatrix())),
                  differences);
  const BulletRows inverse_B = gather(bodies, inverse_inertia_B);
  add_differences(inverse_B, batch.inverse_inertia_B, differences);
  found.changed = ~differences.are_none().bits();
  const BulletRows omega_W = gather(bodies, angular_velocity);
  BulletDifferences differences_of_velocity;
  add_differences(omega_W, batch.written_omega_W, differences_of_velocity);
  found.kicked = ~differences_of_velocity.are_none().bits();
  const BulletRows velocity = gather(bodies, linear_velocity);
  const BulletRows place = gather(bodies, origin);
  const BulletRows torque_W = gather(bodies, total_torque);
  const BulletMask finite =
      are_surely_finite(omega_W, velocity, place, gather(bodies, total_force), torque_W);
  found.finite = finite.bits();
  const BulletMask no_torque =
      (torque_W.x == btScalar(0)) & (torque_W.y == btScalar(0)) & (torque_W.z == btScalar(0));
  batch.torqued = (batch.torqued & ~lanes) | (lanes & ~no_torque.bits());
  const BulletMask known = finite & bullet_mask(lanes);
  batch.linear_velocity = select(known, velocity, batch.linear_velocity);
  batch.origin = select(known, place, batch.origin);
  found.held = are_held(inverse_B, gather(bodies, angular_factor)).bits();
}

// adopt_external_changes for lanes where it is the velocity alone.
POLHODE_FOR_EACH_INSTRUCTION_SET
void adopt_kicks(const BodyPointers& bodies, const LaneBits& lanes, Batch& batch) noexcept {
  const BulletRows omega_W = gather(bodies, angular_velocity);
  const Vector3Wide kicked_W =
      velocity_after_kick(to_double(omega_W), to_double(batch.written_omega_W), batch.omega_W);
  const Vector3Wide L_W =
      batch.R_WB == nullptr
          ? formulas::times_inertia_W(Matrix3Wide(batch.q_WB.toRotationMatrix()), batch.inertia_B(), kicked_W)
          : formulas::angular_momentum_W(*batch.R_WB, batch.inertia_B(), kicked_W);
  const WideMask mask = wide_mask(lanes);
  batch.omega_W = select(mask, kicked_W, batch.omega_W);
  batch.L_W = select(mask, L_W, batch.L_W);
  batch.written_omega_W = select(bullet_mask(lanes), omega_W, batch.written_omega_W);
}

// Bullet switches a body off over a bounding box that is not finite.
bool is_switched_off_by_nan(const btRigidBody& body) {
  return body.getActivationState() == DISABLE_SIMULATION && !is_finite(body);
}

void sanitize_lane(Batch& batch, std::size_t lane) {
  sanitize(*batch.bodies[lane], batch.last_written(lane));
  batch.note(lane, IncidentKind::non_finite_body);
}

// Lanes whose step begins now. A body that has diverged is Bullet's, but still kept from spreading a NaN.
LaneBits lanes_to_begin(Batch& batch) {
  LaneBits lanes;
  batch.has_strangers = false;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const btRigidBody* body = batch.bodies[lane];
    if (body == nullptr || batch.in_step[lane]) continue;
    if (!moves(*body) && !is_switched_off_by_nan(*body)) continue;
    const bool is_the_same = body_identity(*body) == batch.identities[lane];
    if (!is_the_same) batch.has_strangers = true;
    lanes[lane] = is_the_same && !batch.diverged[lane];
    if (is_the_same && batch.diverged[lane] && !is_finite(*body)) sanitize_lane(batch, lane);
  }
  return lanes;
}

void take_over(Batch& batch, std::size_t lane, const Found& found, const StepContext& context) {
  btRigidBody& body = *batch.bodies[lane];
  if (!is_finite(body)) sanitize_lane(batch, lane);
  adopt_external_changes(batch, lane, context.bullet.damping_factor(body.getAngularDamping(), context.dt));
  if (found.finite[lane]) return;
  set_vector_in_lane(lane, body.getLinearVelocity(), batch.linear_velocity);
  set_vector_in_lane(lane, body.getWorldTransform().getOrigin(), batch.origin);
}

void clear_gyroscopic_flags(Batch& batch, std::size_t lane) {
  btRigidBody& body = *batch.bodies[lane];
  const int flags = body.getFlags();
  batch.gyroscopic_flags[lane] = static_cast<std::uint8_t>(flags & kGyroscopicFlags);
  if (batch.gyroscopic_flags[lane] != 0) body.setFlags(flags & ~kGyroscopicFlags);
}

void classify(Batch& batch, std::size_t lane, const StepContext& context) {
  const btRigidBody& body = *batch.bodies[lane];
  const auto index = static_cast<std::size_t>(body.getWorldArrayIndex());
  batch.constrained[lane] = index < context.is_constrained.size() && context.is_constrained[index] != 0;
  batch.given_mean.reset(lane);
  batch.given_effective.reset(lane);
  batch.given_torque.reset(lane);
  batch.unresolved.reset(lane);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void write_given(const BodyPointers& bodies, const LaneBits& lanes, const Vector3Wide& given_W,
                 Batch& batch) noexcept {
  batch.written_omega_W = select(bullet_mask(lanes), to_bullet(given_W), batch.written_omega_W);
  scatter(batch.written_omega_W, bodies, angular_velocity);
}

// I_W (omega' - omega) / dt
POLHODE_FOR_EACH_INSTRUCTION_SET
void find_gyroscopic_torque(const Batch& batch, const Vector3Wide& end_omega_W, const Wide& dt,
                            BulletRows& torque_W) noexcept {
  const Matrix3Wide R_WB = batch.q_WB.toRotationMatrix();
  const Vector3Wide change_W = end_omega_W - batch.omega_W;
  torque_W = to_bullet(Vector3Wide(formulas::times_inertia_W(R_WB, batch.inertia_B(), change_W) / dt));
}

// Schemes that carry omega hand their gyroscopic change to the solver as Bullet's own flags do, as the
// impulse of a torque: then contacts and joints get to know of it where they would of Bullet's.
void give_gyroscopic_torque(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  if (context.dt == btScalar(0)) return;
  WideState end = batch.wide_state();
  step_lanes(batch, lanes, free_input(batch, context.dt), end, nullptr);
  BulletRows torque_W;
  find_gyroscopic_torque(batch, end.omega_W, Wide(static_cast<double>(context.dt)), torque_W);
  if (batch.applied_torque_W == nullptr) batch.applied_torque_W = std::make_unique<BulletRows>();
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    btVector3& torque = total_torque(*batch.bodies[lane]);
    const btVector3 sum = torque + vector_in_lane(torque_W, lane);
    if (!are_finite(sum)) continue;
    set_vector_in_lane(lane, torque, *batch.applied_torque_W);
    batch.given_torque.set(lane);
    torque = sum;
  }
}

// Schemes that turn by the velocity at the start: constrained bodies still show the one of the last turn.
void give_start_velocity(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  write_given(body_pointers(batch, lanes, context.bullet.nobody()), lanes, batch.omega_W, batch);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void find_effective_inertia(const Batch& batch, const Vector3Wide& u_W, const Wide& dt,
                            const TameLimits& limits, EffectiveInertiaResult<Wide>& result) noexcept {
  result = effective_inertia<Wide>(batch.q_WB, batch.L_W, batch.inertia_B(), u_W, dt, limits);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void write_inverse_inertia(const BodyPointers& bodies, const Matrix3Wide& inverse_W) noexcept {
  scatter_basis(to_bullet(inverse_W), bodies, inverse_inertia_tensor_W);
}

// Bodies so slow that the free step changes neither their velocity nor their inertia by more than
// kNegligible.
POLHODE_FOR_EACH_INSTRUCTION_SET
void find_slow(const Batch& batch, const Wide& dt, LaneBits& slow) noexcept {
  const Vector3Wide inertia_B = batch.inertia_B();
  const Wide largest = max(max(inertia_B[0], inertia_B[1]), inertia_B[2]);
  const Wide smallest = min(min(inertia_B[0], inertia_B[1]), inertia_B[2]);
  const Wide change2 = batch.omega_W.squaredNorm() * (dt * dt) * (largest * largest);
  slow = (change2 < (kNegligible * kNegligible) * (smallest * smallest)).bits();
}

// Schemes whose turn has no constant velocity: constrained bodies are given the mean one.
void give_mean_velocity(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  const Wide dt = static_cast<double>(context.dt);
  WideState end = batch.wide_state();
  step_lanes(batch, lanes, free_input(batch, context.dt), end, nullptr);
  Vector3Wide u_W;
  mean_angular_velocities_W(batch.q_WB, end.q_WB, batch.omega_W, dt, u_W);
  EffectiveInertiaResult<Wide> found;
  const bool takes_M = context.solver_takes_effective_inertia;
  find_effective_inertia(batch, u_W, dt, takes_M ? kTameWithM : kTameWithoutM, found);

  if (batch.effective == nullptr) batch.effective = std::make_unique<EffectiveInertia<Wide>>();
  *batch.effective = found.effective;
  batch.given_mean |= lanes & found.is_tame.bits();
  batch.unresolved |= lanes & ~found.is_tame.bits();
  write_given(body_pointers(batch, lanes, context.bullet.nobody()), lanes,
              select(found.is_tame, u_W, batch.omega_W), batch);
  if (!takes_M) return;
  const LaneBits effective = batch.given_mean & lanes & ~found.is_negligible.bits();
  batch.given_effective |= effective;
  if (effective.any()) {
    write_inverse_inertia(body_pointers(batch, effective, context.bullet.nobody()), found.inverse_W);
  }
}

void give_constrained(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  LaneBits slow;
  find_slow(batch, Wide(static_cast<double>(context.dt)), slow);
  slow &= lanes;
  if (slow.any())
    write_given(body_pointers(batch, slow, context.bullet.nobody()), slow, batch.omega_W, batch);
  if (slow != lanes) give_mean_velocity(batch, lanes & ~slow, context);
}

}  // namespace

void before_solve(Batch& batch, const StepContext& context) noexcept {
  const LaneBits lanes = lanes_to_begin(batch);
  if (lanes.none()) return;
  const BodyPointers bodies = body_pointers(batch, lanes, context.bullet.nobody());
  Found found;
  compare_with_written(bodies, lanes, batch, found);
  LaneBits only_kicked = lanes & found.kicked & found.finite & ~found.changed & ~found.held;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    if (batch.bodies[lane]->getAngularDamping() != btScalar(0)) only_kicked.reset(lane);
    const bool is_changed = found.changed[lane] || found.kicked[lane] || !found.finite[lane];
    if (is_changed && !only_kicked[lane]) take_over(batch, lane, found, context);
    if (batch.steps[lane] == 0) {
      batch.start(lane);
      only_kicked.reset(lane);
    }
    clear_gyroscopic_flags(batch, lane);
    classify(batch, lane, context);
  }
  if (only_kicked.any()) adopt_kicks(bodies, only_kicked, batch);
  batch.held = (batch.held & ~lanes) | (found.held & lanes);
  batch.in_step |= lanes;

  const LaneBits free_to_turn = lanes & ~batch.held;
  const LaneBits constrained = free_to_turn & batch.constrained;
  if (batch.turn_velocity == TurnVelocity::end && constrained.any()) {
    give_gyroscopic_torque(batch, constrained, context);
  } else if (batch.turn_velocity == TurnVelocity::start && constrained.any()) {
    give_start_velocity(batch, constrained, context);
  } else if (batch.turn_velocity == TurnVelocity::mean && constrained.any()) {
    give_constrained(batch, constrained, context);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (lanes[lane] && batch.held[lane]) give_held(batch, lane, context);
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
