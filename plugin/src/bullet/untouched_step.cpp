#include "bullet/untouched_step.h"

#include "bullet/block_rows.h"
#include "bullet/inertia_tensors.h"
#include "bullet/lane_turn.h"
#include "bullet/unpublished_members.h"
#include "lanes/instruction_sets.h"
#include "lanes/mean_angular_velocity.h"
#include "polhode/rotation_limits.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// At the end of the step.
struct Place {
  BulletRows origin;
  BulletRows velocity;
};

struct Start {
  LaneInput input;
  LaneState state;
  Place place;  // at the end
  BlockLanes is_in_place;
};

// As read_state and start_step.
void read(const BlockRows& block, btScalar dt, const BulletRows& solved_W, Start& start) {
  set_orientation(start.state, block.load_q_WB());
  start.state.omega_W = block.load(&BodyNumbers::omega_W);
  start.state.L_W = block.load(&BodyNumbers::L_W);
  start.input.inertia_B = to_double(block.load(&BodyNumbers::inverse_inertia_B)).cwiseInverse();
  start.input.delta_omega_W = to_double(solved_W) - to_double(to_bullet(start.state.omega_W));
  start.input.dt = double(dt);
  start.input.turn_dt = double(dt);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void start_left_out(const BlockRows& block, btScalar dt, Start& start) noexcept {
  const BulletRows omega_W = load_omega_W(block);
  read(block, dt, omega_W, start);
  start.place.velocity = load_linear_velocity(block);
  start.place.origin = moved(block.load(origin_of), start.place.velocity, dt);
  BulletDifferences differences;
  add_differences(load_world_bases(block), to_bullet(start.state.R_WB), differences);
  start.is_in_place = differences.are_none().bits() &
                      are_surely_finite(omega_W, start.place.velocity, start.place.origin).bits();
}

// Where Bullet has made its turn: that and nothing else shows in the pose.
POLHODE_FOR_EACH_INSTRUCTION_SET
void start_made(const BlockRows& block, btScalar dt, Start& start) noexcept {
  const BulletRows solved_W = block.load(interpolated_omega_of);
  read(block, dt, solved_W, start);
  start.place.velocity = load_linear_velocity(block);
  start.place.origin = block.load(origin_of);
  LaneTurn turn = begin_turn(to_bullet(start.state.R_WB), solved_W, dt);
  take_sine_and_cosine(turn);
  BulletMask is_turned;
  const LaneBasis expected = end_turn(turn, dt, is_turned);
  const LaneBasis found = load_world_bases(block);
  const BulletRows inverse_inertia_B = load_inverse_inertia_B(block);
  BulletDifferences differences;
  add_differences(found, expected, differences);
  add_differences(found, load_bases([&](std::size_t lane) -> auto& {
                    return interpolated_basis_of(*block.bodies[lane]);
                  }),
                  differences);
  add_differences(load_omega_W(block), solved_W, differences);
  add_differences(inverse_inertia_B, block.load(&BodyNumbers::inverse_inertia_B), differences);
  const BulletRows force_W = load_force_W(block);
  const BulletRows torque_W = load_torque_W(block);
  start.is_in_place =
      differences.are_none().bits() & turn_freely(block, inverse_inertia_B, torque_W).bits() &
      are_surely_finite(solved_W, start.place.velocity, start.place.origin, force_W, torque_W).bits();
}

// As within_limits.
BlockLanes within_limits(const LaneState& state, bool are_rotations) {
  const Vector3L L_probe = 0.0 * state.L_W;
  const auto q_probe = QuaternionL(state.q_WB.coeffs() * Lanes(0.0));
  Lanes probe = L_probe[0] + L_probe[1] + L_probe[2] + q_probe.x() + q_probe.y() + q_probe.z() + q_probe.w();
  BlockLanes result = (state.omega_W.squaredNorm() <= kMaximumAngularSpeed * kMaximumAngularSpeed).bits();
  if (!are_rotations) {
    for (int i = 0; i < 3; ++i) {
      const Lanes square = state.R_WB.col(i).squaredNorm();
      probe += 0.0 * square;
      result &= (square <= kMaximumSwelling * kMaximumSwelling).bits();
    }
  }
  return result & (probe == 0.0).bits();
}

struct End {
  const Vector3L& start_L_W;
  const LaneState& state;
  const Place& place;
  const Vector3L& mean_omega_W;
  bool are_rotations;
};

// As accept_step and write_step. False: a scheme has diverged, and nothing is written.
POLHODE_FOR_EACH_INSTRUCTION_SET
bool write(const BlockRows& block, const End& end, bool tensors_too) noexcept {
  if (!within_limits(end.state, end.are_rotations).all()) return false;
  block.store_q_WB(end.state.q_WB);
  block.store(end.state.omega_W, &BodyNumbers::omega_W);
  // Written only if it differs, see begin.
  LaneDifferences differences;
  for (int i = 0; i < 3; ++i) differences.add(end.state.L_W[i], end.start_L_W[i]);
  if (!all(differences.are_none())) block.store(end.state.L_W, &BodyNumbers::L_W);

  const LaneBasis basis = to_bullet(Matrix3L(end.state.q_WB.toRotationMatrix()));
  store_transforms(
      basis,
      end.place.origin, [&](std::size_t lane) -> auto& { return block.bodies[lane]->getWorldTransform(); });
  store_transforms(
      basis, end.place.origin, [&](std::size_t lane) -> auto& {
        return block.bodies[lane]->getInterpolationWorldTransform();
      });
  if (tensors_too) {
    store_bases(
        inverse_inertia_tensor_W(basis, block.load(&BodyNumbers::inverse_inertia_B)),
        [&](std::size_t lane) -> auto& { return inverse_inertia_tensor_W(*block.bodies[lane]); });
  }

  block.store(end.place.origin, &BodyNumbers::origin);
  block.store(end.place.velocity, &BodyNumbers::linear_velocity);
  block.store(to_bullet(end.state.omega_W), omega_of);
  block.store(end.place.velocity, interpolated_velocity_of);
  block.store(to_bullet(end.mean_omega_W), interpolated_omega_of);
  return true;
}

using ColumnsOfBodies = std::array<double*, kLanes>;

ColumnsOfBodies swollen_columns(const BodyBlock& block) {
  ColumnsOfBodies result;
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    result[lane] = block.bodies[lane]->swollen_columns().data();
  return result;
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void load(const ColumnsOfBodies& columns, Matrix3L& R_WB) noexcept {
  for (int i = 0; i < 3; ++i) {
    const auto column = load_rows<double>([&](std::size_t lane) { return columns[lane] + 4 * i; });
    R_WB.col(i) = Vector3L(column.x, column.y, column.z);
  }
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void store(const Matrix3L& R_WB, const ColumnsOfBodies& columns) noexcept {
  for (int i = 0; i < 3; ++i) {
    store_rows(LaneRows<double>{R_WB(0, i), R_WB(1, i), R_WB(2, i)},
               [&](std::size_t lane) { return columns[lane] + 4 * i; });
  }
}

// Where the scheme of one of them diverged.
void finish_alone(const BodyBlock& block, BulletsTurn bullets_turn, const End& end, btScalar dt) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    PendingStep step;
    step.bullets_turn = bullets_turn;
    step.has_late_kick = false;
    step.input.dt = dt;
    get_lane(lane, end.state, step.state);
    get_lane(lane, end.mean_omega_W, step.mean_omega_W);
    if (block.bodies[lane]->accept_step(step)) block.bodies[lane]->write_step(step);
  }
}

}  // namespace

BlockLanes step_untouched(const BodyBlock& bodies, BulletsTurn bullets_turn, const LaneScheme& scheme,
                          btScalar dt) {
  const BlockRows block(bodies);
  Start start;
  (bullets_turn == BulletsTurn::made ? start_made : start_left_out)(block, dt, start);
  if (!start.is_in_place.all()) return start.is_in_place;

  const bool are_rotations = bodies.bodies.front()->keeps_rotation();
  SchemeMemory nobodys;
  LaneMemories memories{{}, kLanes};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    memories.of[lane] = &bodies.bodies[lane]->memory_of_scheme(nobodys);
  }
  LaneState& state = start.state;
  const QuaternionL start_q_WB = state.q_WB;
  const Vector3L start_L_W = state.L_W;
  if (!are_rotations) load(swollen_columns(bodies), state.R_WB);
  scheme.step_lanes(start.input, state, memories);
  Vector3L mean_omega_W;
  mean_angular_velocities_W(start_q_WB, state.q_WB, dt, mean_omega_W);

  const End end = {start_L_W, state, start.place, mean_omega_W, are_rotations};
  if (!write(block, end, inertia_tensors_in_lanes())) {
    finish_alone(bodies, bullets_turn, end, dt);
    return start.is_in_place;
  }
  if (!are_rotations) store(state.R_WB, swollen_columns(bodies));
  for (ManagedBody* body : bodies.bodies) {
    body->finish_untouched();
    if (!inertia_tensors_in_lanes()) body->address()->updateInertiaTensor();
  }
  return start.is_in_place;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
