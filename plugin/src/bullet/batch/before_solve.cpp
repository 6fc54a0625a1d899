#include "bullet/batch/stages.h"
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

// Bullet deactivates a body whose bounding box is not finite.
bool is_switched_off_by_nan(const btRigidBody& body) {
  return body.getActivationState() == DISABLE_SIMULATION && !is_finite(body);
}

// Returns the lanes whose body moves and whose step predict has not begun.
LaneBits lanes_to_begin(const Batch& batch) {
  LaneBits lanes;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const btRigidBody* body = batch.bodies[lane];
    if (body == nullptr || batch.begun[lane] || batch.diverged[lane]) continue;
    lanes.set(lane, moves(*body) || is_switched_off_by_nan(*body));
  }
  return lanes;
}

// Returns the lanes whose step has begun and whose body is still the same. During collision detection Bullet
// deactivates a body whose bounding box is too large; such a body takes no step. Keeps bodies that are not
// finite, so that they are sanitized.
LaneBits lanes_to_solve(Batch& batch) {
  LaneBits lanes = batch.begun & ~batch.in_solve;
  batch.has_replaced_bodies = false;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    if (batch.is_replaced(lane)) {
      batch.has_replaced_bodies = true;
      lanes.reset(lane);
    } else if (!moves(*batch.bodies[lane]) && is_finite(*batch.bodies[lane])) {
      lanes.reset(lane);
      batch.leave_step(lane);
    }
  }
  return lanes;
}

void clear_gyroscopic_flags(Batch& batch, std::size_t lane) {
  btRigidBody& body = *batch.bodies[lane];
  const int flags = body.getFlags();
  batch.gyroscopic_flags[lane] = static_cast<std::uint8_t>(flags & kGyroscopicFlags);
  if (batch.gyroscopic_flags[lane] != 0) body.setFlags(flags & ~kGyroscopicFlags);
}

// Restores the flags cleared by clear_gyroscopic_flags.
void leave_to_bullet(Batch& batch, std::size_t lane) {
  btRigidBody& body = *batch.bodies[lane];
  body.setFlags(body.getFlags() | batch.gyroscopic_flags[lane]);
  batch.leave_step(lane);
}

// Treats a body without a mark as constrained, which costs a free body only a rounding error.
LaneBits constrained_lanes(const Batch& batch, const LaneBits& lanes, const StepContext& context) {
  LaneBits constrained;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const auto index = static_cast<std::size_t>(batch.world_index[lane]);
    constrained.set(
        lane, lanes[lane] && (index >= context.is_constrained.size() || context.is_constrained[index] != 0));
  }
  return constrained;
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

// Returns the end of the free step. Stores the contribution of torque law and motors.
WideState free_end(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  WideState end = batch.wide_state();
  batch.step(lanes, batch.free_input(context.dt), end, nullptr);
  if (batch.driven != nullptr) keep_gain(batch, lanes, end);
  return end;
}

// Gives the gyroscopic change of a scheme that carries omega to the solver as the impulse of a torque, as
// Bullet's own flags do, so that contacts and joints respond to it in the same way.
void give_gyroscopic_torque(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  if (context.dt == btScalar(0) || make_if_null(batch.applied_torque_W) == nullptr) return;
  const WideState end = free_end(batch, lanes, context);
  BulletRows torque_W;
  find_gyroscopic_torque(batch, end.omega_W, Wide(static_cast<double>(context.dt)), torque_W);
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

// Returns omega plus the change by torque law and motors. Call after free_end.
Vector3Wide start_velocity_W(const Batch& batch) {
  return batch.driven == nullptr ? batch.omega_W : omega_with_gain_W(batch);
}

// For schemes that turn by the start velocity: a constrained body still holds the velocity of its last turn.
void give_start_velocity(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  if (batch.driven != nullptr) free_end(batch, lanes, context);
  write_given(body_pointers(batch, lanes, context.bullet.placeholder()), lanes, start_velocity_W(batch),
              batch);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void find_effective_inertia(const Batch& batch, const Vector3Wide& u_W, const Wide& dt,
                            double symmetric_limit, const Wide& antisymmetric_limit,
                            EffectiveInertiaResult<Wide>& result) noexcept {
  result = effective_inertia<Wide>(batch.q_WB, batch.L_W, batch.inertia_B(), u_W, dt, symmetric_limit,
                                   antisymmetric_limit);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void write_inverse_inertia(const BodyPointers& bodies, const Matrix3Wide& inverse_W) noexcept {
  scatter_basis(to_bullet(inverse_W), bodies, inverse_inertia_tensor_W);
}

// Finds bodies so slow that the free step changes neither their velocity nor their inertia by more than
// kNegligible.
POLHODE_FOR_EACH_INSTRUCTION_SET
void find_slow(const Batch& batch, const Wide& dt, LaneBits& slow) noexcept {
  const Vector3Wide inertia_B = batch.inertia_B();
  const Wide largest = max(max(inertia_B[0], inertia_B[1]), inertia_B[2]);
  const Wide smallest = min(min(inertia_B[0], inertia_B[1]), inertia_B[2]);
  const Wide change2 = batch.omega_W.squaredNorm() * (dt * dt) * (largest * largest);
  slow = (change2 < (kNegligible * kNegligible) * (smallest * smallest)).lanes();
}

Wide antisymmetric_limits(const Batch& batch, double without_rotors, bool takes_M) {
  Wide limits = without_rotors;
  for (std::size_t lane = 0; lane < kLanes && takes_M && batch.driven != nullptr; ++lane) {
    const Drive* const drive = batch.driven->drives[lane];
    if (drive != nullptr && !drive->rotor_momentum_B.isZero(0.0)) limits.set(lane, kResolvedWithRotors);
  }
  return limits;
}

// For schemes whose turn has no constant velocity: gives constrained bodies the mean velocity.
void give_mean_velocity(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  if (make_if_null(batch.effective) == nullptr) {
    give_start_velocity(batch, lanes, context);
    batch.unresolved |= lanes;
    return;
  }
  const Wide dt = static_cast<double>(context.dt);
  const WideState end = free_end(batch, lanes, context);
  Vector3Wide u_W;
  mean_angular_velocities_W(batch.q_WB, end.q_WB, batch.omega_W, dt, u_W);
  EffectiveInertiaResult<Wide> found;
  const bool takes_M = context.solver_takes_effective_inertia;
  const ResolutionLimits& limits = takes_M ? kResolvedWithM : kResolvedWithoutM;
  find_effective_inertia(batch, u_W, dt, limits.symmetric,
                         antisymmetric_limits(batch, limits.antisymmetric, takes_M), found);

  *batch.effective = found.effective;
  batch.given_mean |= lanes & found.is_resolved.lanes();
  batch.unresolved |= lanes & ~found.is_resolved.lanes();
  write_given(body_pointers(batch, lanes, context.bullet.placeholder()), lanes,
              select(found.is_resolved, u_W, start_velocity_W(batch)), batch);
  if (!takes_M) return;
  const LaneBits effective = batch.given_mean & lanes & ~found.is_negligible.lanes();
  batch.given_effective |= effective;
  if (effective.any()) {
    write_inverse_inertia(body_pointers(batch, effective, context.bullet.placeholder()), found.inverse_W);
  }
}

void give_constrained(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  if (batch.driven != nullptr) {  // slow bodies too may have a torque or a fast rotor
    give_mean_velocity(batch, lanes, context);
    return;
  }
  LaneBits slow;
  find_slow(batch, Wide(static_cast<double>(context.dt)), slow);
  slow &= lanes;
  if (slow.any())
    write_given(body_pointers(batch, slow, context.bullet.placeholder()), slow, batch.omega_W, batch);
  if (slow != lanes) give_mean_velocity(batch, lanes & ~slow, context);
}

}  // namespace

void sanitize_left_to_bullet(Batch& batch, const LaneBits& lanes) noexcept {
  for (std::size_t lane = 0; lane < kLanes && lanes.any(); ++lane) {
    if (!lanes[lane] || batch.bodies[lane] == nullptr || batch.is_replaced(lane)) continue;
    const btRigidBody& body = *batch.bodies[lane];
    if ((moves(body) || is_switched_off_by_nan(body)) && !is_finite(body)) batch.sanitize(lane);
  }
}

void before_solve(Batch& batch, const StepContext& context) noexcept {
  sanitize_left_to_bullet(batch, batch.diverged);
  const LaneBits beginning = lanes_to_begin(batch);
  if (beginning.any()) begin_step(batch, beginning, context);
  const LaneBits lanes = lanes_to_solve(batch);
  if (lanes.none()) return;
  batch.in_solve |= lanes;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (lanes[lane]) clear_gyroscopic_flags(batch, lane);
  }
  const LaneBits constrained = constrained_lanes(batch, lanes, context);
  batch.constrained = (batch.constrained & ~lanes) | constrained;
  for (LaneBits* given :
       {&batch.given_mean, &batch.given_effective, &batch.given_torque, &batch.unresolved}) {
    *given &= ~lanes;
  }
  const LaneBits looked_at_again = constrained & ~beginning;
  if (looked_at_again.any()) adopt_changes(batch, looked_at_again, context);

  if (batch.driven != nullptr) begin_drive(batch, lanes, context);

  const LaneBits turning = constrained & ~batch.held;
  if (batch.turn_velocity == TurnVelocity::end && turning.any()) {
    give_gyroscopic_torque(batch, turning, context);
  } else if (batch.turn_velocity == TurnVelocity::start && turning.any()) {
    give_start_velocity(batch, turning, context);
  } else if (batch.turn_velocity == TurnVelocity::mean && turning.any()) {
    give_constrained(batch, turning, context);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane] || !batch.held[lane]) continue;
    if (make_if_null(batch.held_turns) != nullptr) {
      give_held(batch, lane, context);
    } else {
      leave_to_bullet(batch, lane);
    }
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
