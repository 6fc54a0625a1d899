#include <limits>

#include "bullet/batch/stages.h"
#include "bullet/batch/write_step.h"
#include "bullet/body/external_changes.h"
#include "bullet/body/integrated_pose.h"
#include "bullet/body/locked_axes.h"
#include "bullet/body/non_finite.h"
#include "math/mean_angular_velocity.h"
#include "polhode/bullet/conversions.h"
#include "simd/instruction_sets.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

POLHODE_FOR_EACH_INSTRUCTION_SET
void read_solved(const BodyPointers& bodies, PoseIntegratedBy integrator, btScalar dt, const Batch& batch,
                 Solved& solved, WideStepInput& input) noexcept {
  const BulletRows omega_W = gather(bodies, angular_velocity);
  const bool by_bullet = integrator == PoseIntegratedBy::bullet;
  // Bullet may have changed the velocity after integrating with it (speculative contact restitution).
  solved.omega_W = by_bullet ? gather(bodies, interpolation_angular_velocity) : omega_W;
  solved.shown_later_W = omega_W;
  solved.linear_velocity = gather(bodies, linear_velocity);
  solved.origin = gather(bodies, origin);
  const auto& v = solved.linear_velocity;
  if (by_bullet) {
    solved.turned = batch.constrained;
  } else {
    solved.origin = {solved.origin.x + v.x * dt, solved.origin.y + v.y * dt, solved.origin.z + v.z * dt};
    BulletDifferences turns;
    add_differences(gather_basis(bodies, basis), to_bullet(Matrix3Wide(batch.q_WB.toRotationMatrix())),
                    turns);
    solved.turned = ~turns.are_none().lanes();
  }
  BulletDifferences differences;
  add_differences(solved.omega_W, batch.written_omega_W, differences);
  solved.acted = ~differences.are_none().lanes();
  solved.finite = are_surely_finite(omega_W, solved.omega_W, v, solved.origin).lanes();
  const Vector3Wide change_W = to_double(solved.omega_W) - to_double(batch.written_omega_W);
  input = {batch.inertia_B(), change_W, Wide(static_cast<double>(dt))};
}

// Restores the application's flags and torques, which were replaced for the solve.
void restore(const Batch& batch, const LaneBits& lanes) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    btRigidBody& body = *batch.bodies[lane];
    if (batch.gyroscopic_flags[lane] != 0) body.setFlags(body.getFlags() | batch.gyroscopic_flags[lane]);
    if (batch.given_torque[lane]) total_torque(body) = vector_in_lane(*batch.applied_torque_W, lane);
  }
}

// Also checks the origin at the end of the step, which the body does not hold yet if the library integrates.
bool ends_finite(const btRigidBody& body, const Solved& solved, std::size_t lane) {
  return solved.finite[lane] || (is_finite(body) && are_finite(vector_in_lane(solved.origin, lane)));
}

// Returns the lanes whose body still moves and is finite. The others take no step.
LaneBits lanes_to_step(Batch& batch, const LaneBits& lanes, const Solved& solved) {
  LaneBits stepping = lanes;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    btRigidBody& body = *batch.bodies[lane];
    if (!ends_finite(body, solved, lane)) {
      batch.sanitize(lane);
      stepping.reset(lane);
    } else if (!moves(body)) {
      if (batch.given_effective[lane] || batch.held[lane]) body.updateInertiaTensor();
      stepping.reset(lane);
    }
  }
  return stepping;
}

// Computes the turn velocity: the velocity given to the solver, in double, plus the solver's change.
POLHODE_FOR_EACH_INSTRUCTION_SET
void find_turn_velocity(const Batch& batch, const Solved& solved, const Vector3Wide& d_W,
                        Vector3Wide& result) noexcept {
  result = batch.driven == nullptr ? batch.omega_W : omega_with_gain_W(batch);
  if (batch.given_mean.any()) result = select(wide_mask(batch.given_mean), batch.effective->u_W, result);
  result = select(wide_mask(batch.given_torque), to_double(solved.omega_W), Vector3Wide(result + d_W));
}

// Returns the momentum gained with d: I_W(q) d, or M d if the solver had the effective inertia.
Vector3Wide momentum_gain_W(const Batch& batch, const Vector3Wide& d_W, const BulletRows& torque_W,
                            const Wide& dt) {
  const Matrix3Wide R_WB = batch.q_WB.toRotationMatrix();
  const Vector3Wide plain_W = formulas::times_inertia_W(R_WB, batch.inertia_B(), d_W);
  if (batch.given_effective.none()) return plain_W;
  // Bullet multiplies a torque by the transposed inverse inertia, which differs unless that is symmetric.
  const Matrix3Wide& M_W = batch.effective->M_W;
  const Vector3Wide impulse_W = to_double(torque_W) * dt;
  const Vector3Wide by_torque_W = formulas::inverse_transposed(M_W) * impulse_W;
  const Vector3Wide effective_W = M_W * Vector3Wide(d_W - by_torque_W) + impulse_W;
  return select(wide_mask(batch.given_effective), effective_W, plain_W);
}

// Computes L' of lanes whose orientation has turned by velocity_W = (the velocity given to the solver) + d_W.
POLHODE_FOR_EACH_INSTRUCTION_SET
void find_turned_momentum(const Batch& batch, const BodyPointers& bodies, const Vector3Wide& velocity_W,
                          const Vector3Wide& d_W, const Wide& dt, WideState& turned) noexcept {
  const Vector3Wide inertia_B = batch.inertia_B();
  Vector3Wide resolved_L_W = batch.L_W + momentum_gain_W(batch, d_W, gather(bodies, total_torque), dt);
  if (batch.driven != nullptr) resolved_L_W += gain_W(batch);
  const Vector3Wide plain_L_W =
      with_rotor(turned, formulas::times_inertia_W(turned.R_WB, inertia_B, velocity_W));
  const WideMask is_plain = wide_mask(batch.unresolved | batch.given_torque);
  set_angular_momentum(turned, inertia_B, select(is_plain, plain_L_W, resolved_L_W));
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void select_turned(const LaneBits& lanes, const WideState& turned, const Vector3Wide& velocity_W,
                   StepResult& result) noexcept {
  const WideMask mask = wide_mask(lanes);
  result.state = select(mask, turned, result.state);
  result.shown_W = select(mask, velocity_W, result.shown_W);
  result.mean_W = select(mask, velocity_W, result.mean_W);
}

// Rotates constrained bodies by the velocity that the solver computed.
void turn_by_solved(Batch& batch, const LaneBits& lanes, const WideStepInput& input, const Solved& solved,
                    const StepContext& context, StepResult& result) {
  Vector3Wide velocity_W;
  find_turn_velocity(batch, solved, input.delta_omega_W, velocity_W);
  WideState turned = batch.wide_state();
  batch.turn(lanes, velocity_W, context.dt, turned);
  if (batch.driven != nullptr) turned.rotor_momentum_B = rotor_end_B(batch, lanes);
  find_turned_momentum(batch, body_pointers(batch, lanes, context.bullet.placeholder()), velocity_W,
                       input.delta_omega_W, input.dt, turned);
  select_turned(lanes, turned, velocity_W, result);
}

LaneBits lanes_that_turn_by_solved(const Batch& batch, const Solved& solved) {
  if (batch.turn_velocity == TurnVelocity::mean) return batch.constrained & (solved.acted | batch.unresolved);
  return batch.given_torque;
}

// Bullet rounds the change of velocity by a torque, and loses that of a weak torque. If nothing else acted,
// computes the kick from the torque in double instead.
POLHODE_FOR_EACH_INSTRUCTION_SET
void refine_kick(const Batch& batch, const BodyPointers& bodies, const LaneBits& lanes, const Solved& solved,
                 WideStepInput& input) noexcept {
  constexpr double kRounding = 8.0 * std::numeric_limits<btScalar>::epsilon();  // of the solver's sums
  const Vector3Wide& inertia_B = input.inertia_B;
  const Vector3Wide impulse_W = to_double(gather(bodies, total_torque)) * input.dt;
  const Vector3Wide by_torque_W =
      formulas::times_inverse_inertia_W(Matrix3Wide(batch.q_WB.toRotationMatrix()), inertia_B, impulse_W);
  const Vector3Wide rest_W = input.delta_omega_W - by_torque_W;
  const Wide least_moment = min(min(inertia_B[0], inertia_B[1]), inertia_B[2]);
  const Wide size2 =
      to_double(solved.omega_W).squaredNorm() + impulse_W.squaredNorm() / (least_moment * least_moment);
  const WideMask acts_alone = rest_W.squaredNorm() <= kRounding * kRounding * size2;
  input.delta_omega_W = select(wide_mask(lanes) & acts_alone, by_torque_W, input.delta_omega_W);
}

void take_free_steps(Batch& batch, const LaneBits& lanes, const WideStepInput& input, const Solved& solved,
                     StepResult& result) {
  batch.step(lanes, input, result.state, batch.memory.get());
  result.shown_W = result.state.omega_W;
  if (batch.turn_velocity != TurnVelocity::mean && batch.constrained.any()) {
    result.shown_W =
        select(wide_mask(batch.constrained & solved.acted), to_double(solved.omega_W), result.shown_W);
  }
  mean_angular_velocities_W(batch.q_WB, result.state.q_WB, result.shown_W, input.dt, result.mean_W);
}

void take_held_step(const Batch& batch, std::size_t lane, const Solved& solved, const StepContext& context,
                    StepResult& result) {
  Vector3 turn_W = to_double(vector_in_lane(solved.omega_W, lane));
  set_lane(lane, step_held(batch, lane, context, turn_W), result.state);
  set_lane(lane, turn_W, result.shown_W);
  set_lane(lane, turn_W, result.mean_W);
}

}  // namespace

void after_solve(Batch& batch, LaneBits lanes, PoseIntegratedBy integrator,
                 const StepContext& context) noexcept {
  if (lanes.none()) return;
  restore(batch, lanes);
  batch.begun &= ~lanes;
  batch.in_solve &= ~lanes;
  Solved solved;
  WideStepInput input;
  read_solved(body_pointers(batch, lanes, context.bullet.placeholder()), integrator, context.dt, batch,
              solved, input);
  const LaneBits stepping = lanes_to_step(batch, lanes, solved);
  if (stepping.none()) return;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (stepping[lane] && solved.turned[lane]) adopt_split_impulse(batch, lane, integrator, solved, context);
  }

  const LaneBits turning_by_solved = stepping & ~batch.held & lanes_that_turn_by_solved(batch, solved);
  StepResult result = {batch.wide_state(), batch.omega_W, batch.omega_W, turning_by_solved};
  const LaneBits free = stepping & ~result.turns_by_solved & ~batch.held;
  const LaneBits torqued = free & batch.torqued & ~batch.constrained;
  if (torqued.any()) {
    refine_kick(batch, body_pointers(batch, torqued, context.bullet.placeholder()), torqued, solved, input);
  }
  if (free.any()) take_free_steps(batch, free, input, solved, result);
  if (result.turns_by_solved.any()) {
    turn_by_solved(batch, result.turns_by_solved, input, solved, context, result);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (stepping[lane] && batch.held[lane]) take_held_step(batch, lane, solved, context, result);
    if (stepping[lane] && integrator == PoseIntegratedBy::bullet)
      clamp_step(batch, lane, solved, context, result);
  }
  write_step(batch, stepping, integrator, solved, result, context);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
