#include "bullet/body/locked_axes.h"

#include <Eigen/LU>

#include "bullet/body/external_changes.h"
#include "bullet/body/non_finite.h"
#include "math/mean_angular_velocity.h"
#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Returns true if the moment about a body axis is infinite. With omega 0 about that axis, omega x I omega
// acts only about it: there is no gyroscopic change.
bool has_infinite_moment(const btRigidBody& body) {
  const btVector3& inverse = body.getInvInertiaDiagLocal();
  return inverse.x() == 0 || inverse.y() == 0 || inverse.z() == 0;
}

HeldTurn plain_turn(const RotationState& state, const btVector3& inverse_inertia_B) {
  const Vector3 inertia_B = moments_B(inverse_inertia_B);
  return {state.omega_W, state.R_WB * inertia_B.asDiagonal() * state.R_WB.transpose(),
          state.R_WB * to_double(inverse_inertia_B).asDiagonal() * state.R_WB.transpose(), false};
}

Vector3 mean_angular_velocity_W(const RotationState& start, const RotationState& end, double dt) {
  WideState wide_start;
  WideState wide_end;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    set_lane(lane, start, wide_start);
    set_lane(lane, end, wide_end);
  }
  Vector3Wide wide_result;
  mean_angular_velocities_W(wide_start.q_WB, wide_end.q_WB, wide_start.omega_W, Wide(dt), wide_result);
  Vector3 result;
  get_lane(0, wide_result, result);
  return result;
}

HeldTurn free_turn(const Batch& batch, std::size_t lane, const StepContext& context) {
  const btRigidBody& body = *batch.bodies[lane];
  const RotationState start = batch.state(lane);
  HeldTurn turn = plain_turn(start, body.getInvInertiaDiagLocal());
  if (has_infinite_moment(body) || batch.turn_velocity == TurnVelocity::start) return turn;
  const StepInput input = {moments_B(body.getInvInertiaDiagLocal()), Vector3::Zero(),
                           static_cast<double>(context.dt)};
  RotationState end = start;
  batch.scheme->step(input, end);
  if (batch.turn_velocity == TurnVelocity::end) {
    turn.velocity_W = end.omega_W;
    return turn;
  }
  const Vector3 mean_W = mean_angular_velocity_W(start, end, input.dt);
  const ResolutionLimits& limits =
      context.solver_takes_effective_inertia ? kResolvedWithM : kResolvedWithoutM;
  const auto found = effective_inertia<double>(start.q_WB, start.L_W, input.inertia_B, mean_W, input.dt,
                                               limits.symmetric, limits.antisymmetric);
  turn.is_resolved = found.is_resolved;
  if (!turn.is_resolved) return turn;
  turn.velocity_W = mean_W;
  if (!found.is_negligible && context.solver_takes_effective_inertia) {
    turn.momentum_W = found.effective.M_W;
    turn.inverse_W = found.inverse_W;
    turn.is_effective = true;
  }
  return turn;
}

void add_drive(Batch& batch, std::size_t lane, const StepContext& context, HeldTurn& turn) {
  DrivenLanes& driven = *batch.driven;
  const RotationState start = batch.state(lane);
  const StepInput input = {moments_B(batch.bodies[lane]->getInvInertiaDiagLocal()), Vector3::Zero(),
                           static_cast<double>(context.dt)};
  const DriveGain gain =
      gain_at_start(*batch.scheme, input, driven.starts[lane], *driven.drives[lane], start);
  turn.gain_W = gain.L_W;
  turn.rotor_end_B = gain.rotor_end_B;
  const Vector3 of_rotor_W = start.R_WB * (gain.rotor_end_B - start.rotor_momentum_B);
  turn.driven_W = turn.inverse_W * (gain.L_W - of_rotor_W);
  turn.velocity_W += turn.driven_W;
  driven.last_torques[lane] = gain.last_torque;
  driven.law_failed.set(lane, gain.law_failed);
}

// Keeps the rotation about a locked axis, which the solver does not change either.
Vector3 with_locked_axes_kept(const Matrix3& inverse_inertia_W, const btRigidBody& body,
                              const Vector3& shown_W, const Vector3& v_W) {
  const Vector3 factor = to_double(body.getAngularFactor());
  const Vector3 locked_W = (factor.array() == 0.0).select(shown_W, Vector3::Zero());
  return project_onto_unlocked_axes(inverse_inertia_W, factor, v_W - locked_W) + locked_W;
}

}  // namespace

Vector3 project_onto_unlocked_axes(const Matrix3& inverse_inertia_W, const Vector3& angular_factor,
                                   const Vector3& v_W) {
  // Locked rows: (W torque)_i = -v_i, scaled to the size of the others; free rows: torque_i = 0. If the body
  // has no inverse inertia about a locked axis, the system would be singular, so the row stays torque_i = 0.
  Matrix3 system = Matrix3::Identity();
  Vector3 right = Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double size = inverse_inertia_W.row(axis).cwiseAbs().maxCoeff();
    if (angular_factor[axis] != 0.0 || size == 0.0) continue;
    system.row(axis) = inverse_inertia_W.row(axis) / size;
    right[axis] = -v_W[axis] / size;
  }
  const Vector3 locking_impulse = system.fullPivLu().solve(right);
  Vector3 result = v_W + inverse_inertia_W * locking_impulse;
  for (int axis = 0; axis < 3; ++axis) {
    if (angular_factor[axis] == 0.0) result[axis] = 0.0;
  }
  return result;
}

void give_held(Batch& batch, std::size_t lane, const StepContext& context) {
  btRigidBody& body = *batch.bodies[lane];
  HeldTurn& turn = (*batch.held_turns)[lane];
  turn = free_turn(batch, lane, context);
  if (batch.driven != nullptr) add_drive(batch, lane, context, turn);
  const btVector3 shown_W = vector_in_lane(batch.written_omega_W, lane);
  btVector3 given_W =
      to_bullet(with_locked_axes_kept(turn.inverse_W, body, to_double(shown_W), turn.velocity_W));
  if (!are_finite(given_W)) {  // dt so long that the scheme's result is not finite
    turn = plain_turn(batch.state(lane), body.getInvInertiaDiagLocal());
    given_W = shown_W;
  }
  body.setAngularVelocity(given_W);
  set_vector_in_lane(lane, given_W, batch.written_omega_W);
  batch.unresolved.set(lane, !turn.is_resolved);
  if (turn.is_effective) to_bullet(turn.inverse_W, inverse_inertia_tensor_W(body));
}

RotationState step_held(const Batch& batch, std::size_t lane, const StepContext& context, Vector3& solved_W) {
  const btRigidBody& body = *batch.bodies[lane];
  const HeldTurn& turn = (*batch.held_turns)[lane];
  const Vector3 given_W = to_double(vector_in_lane(batch.written_omega_W, lane));
  solved_W = with_locked_axes_kept(turn.inverse_W, body, given_W, solved_W);
  Vector3 change_W = solved_W - turn.velocity_W;
  const Vector3 inertia_B = moments_B(body.getInvInertiaDiagLocal());
  const double dt = context.dt;
  RotationState end = batch.state(lane);
  const Vector3 rotor_change_W = end.R_WB * (turn.rotor_end_B - end.rotor_momentum_B);
  end.rotor_momentum_B = turn.rotor_end_B;
  if (has_infinite_moment(body)) {
    set_orientation(end, (exponential(solved_W * dt) * end.q_WB).normalized());
    set_omega(end, inertia_B, solved_W);
  } else if (batch.turn_velocity != TurnVelocity::mean) {
    if (batch.driven != nullptr) {
      end.L_W += rotor_change_W;
      change_W += turn.driven_W;
    }
    batch.scheme->step({inertia_B, change_W, dt}, end);
  } else if (!turn.is_resolved) {
    batch.scheme->turn(solved_W, dt, end);
    set_omega(end, inertia_B, solved_W);
  } else {
    const Vector3 impulse_W = dt * to_double(body.getTotalTorque());
    const Vector3 by_torque_W = turn.inverse_W.transpose() * impulse_W;  // as Bullet multiplies
    Vector3 L_W = end.L_W + turn.momentum_W * (change_W - by_torque_W) + impulse_W;
    if (batch.driven != nullptr) L_W += turn.gain_W;
    batch.scheme->turn(solved_W, dt, end);
    set_angular_momentum(end, inertia_B, L_W);
  }
  return end;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
