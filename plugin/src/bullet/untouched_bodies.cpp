#include "bullet/untouched_bodies.h"

#include "bullet/bullet_lanes.h"
#include "bullet/inertia_tensors.h"
#include "bullet/unpublished_members.h"
#include "lanes/instruction_sets.h"
#include "lanes/mean_angular_velocity.h"
#include "polhode/rotation_limits.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// The bodies of a block and what the library knows of them.
struct Block {
  std::array<btRigidBody*, kLanes> bodies;
  std::array<BodyNumbers*, kLanes> numbers;

  explicit Block(const BodyBlock& block) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      bodies[lane] = block.bodies[lane]->address();
      numbers[lane] = &block.bodies[lane]->numbers();
    }
  }

  // `get(body)` is a btVector3 of Bullet's.
  template <class Get>
  POLHODE_INLINE BulletRows load(Get get) const {
    return load_vectors([&](std::size_t lane) -> auto& { return get(*bodies[lane]); });
  }
  template <class Get>
  POLHODE_INLINE void store(const BulletRows& vectors, Get get) const {
    store_vectors(
        vectors, [&](std::size_t lane) -> auto& { return get(*bodies[lane]); });
  }

  // Behind three numbers there is another member.
  POLHODE_INLINE BulletRows load(PackedVector BodyNumbers::*member) const {
    return load_rows<btScalar>([&](std::size_t lane) { return (numbers[lane]->*member).data(); });
  }
  POLHODE_INLINE void store(const BulletRows& vectors, PackedVector BodyNumbers::*member) const {
    store_rows_of_three(vectors, [&](std::size_t lane) { return (numbers[lane]->*member).data(); });
  }
  POLHODE_INLINE Vector3L load(Vector3 BodyNumbers::*member) const {
    const auto rows = load_rows<double>([&](std::size_t lane) { return (numbers[lane]->*member).data(); });
    return {rows.x, rows.y, rows.z};
  }
  POLHODE_INLINE void store(const Vector3L& v, Vector3 BodyNumbers::*member) const {
    store_rows_of_three(LaneRows<double>{v[0], v[1], v[2]},
                        [&](std::size_t lane) { return (numbers[lane]->*member).data(); });
  }
  POLHODE_INLINE QuaternionL load_q_WB() const {
    const auto rows =
        load_rows_of_four<double>([&](std::size_t lane) { return numbers[lane]->q_WB.coeffs().data(); });
    return {rows.w, rows.x, rows.y, rows.z};
  }
  POLHODE_INLINE void store_q_WB(const QuaternionL& q) const {
    store_rows_of_four(LaneRowsOfFour<double>{q.x(), q.y(), q.z(), q.w()},
                       [&](std::size_t lane) { return numbers[lane]->q_WB.coeffs().data(); });
  }
};

btVector3& origin_of(btRigidBody& body) {
  return body.getWorldTransform().getOrigin();
}

btMatrix3x3& world_basis_of(btRigidBody& body) {
  return body.getWorldTransform().getBasis();
}

btVector3& interpolated_origin_of(btRigidBody& body) {
  return body.getInterpolationWorldTransform().getOrigin();
}

btMatrix3x3& interpolated_basis_of(btRigidBody& body) {
  return body.getInterpolationWorldTransform().getBasis();
}

LaneBasis load_world_bases(const Block& block) {
  return load_bases([&](std::size_t lane) -> auto& { return world_basis_of(*block.bodies[lane]); });
}

// To write to as well, which Bullet lets one do by setters only, one body at a time.
btVector3& omega_of(btRigidBody& body) {
  return const_cast<btVector3&>(body.getAngularVelocity());
}

btVector3& interpolated_velocity_of(btRigidBody& body) {
  return const_cast<btVector3&>(body.getInterpolationLinearVelocity());
}

btVector3& interpolated_omega_of(btRigidBody& body) {
  return const_cast<btVector3&>(body.getInterpolationAngularVelocity());
}

BulletRows load_omega_W(const Block& block) {
  return block.load(omega_of);
}

BulletRows load_inverse_inertia_B(const Block& block) {
  return block.load([](btRigidBody & body) -> auto& { return body.getInvInertiaDiagLocal(); });
}

BulletRows load_force_W(const Block& block) {
  return block.load([](btRigidBody & body) -> auto& { return body.getTotalForce(); });
}

BulletRows load_torque_W(const Block& block) {
  return block.load([](btRigidBody & body) -> auto& { return body.getTotalTorque(); });
}

BulletRows load_linear_velocity(const Block& block) {
  return block.load([](btRigidBody & body) -> auto& { return body.getLinearVelocity(); });
}

BulletLanes sum(const BulletRows& v) {
  return v.x + v.y + v.z;
}

// By a sum, which may also say no of huge numbers.
template <class... Rows>
BulletMask are_surely_finite(const Rows&... rows) {
  return (sum(rows) + ...) * btScalar(0.0) == btScalar(0.0);
}

BulletRows moved(const BulletRows& origin, const BulletRows& velocity, btScalar dt) {
  return {origin.x + velocity.x * dt, origin.y + velocity.y * dt, origin.z + velocity.z * dt};
}

BulletRows same_in_all(btScalar number) {
  return {number, number, number};
}

// Free to turn about all axes, and no torque acts.
BulletMask turn_freely(const Block& block, const BulletRows& inverse_inertia_B, const BulletRows& torque_W) {
  BulletDifferences differences;
  add_differences(torque_W, same_in_all(0), differences);
  add_differences(block.load([](btRigidBody & body) -> auto& { return body.getAngularFactor(); }),
                  same_in_all(1), differences);
  const BulletLanes least = min(min(inverse_inertia_B.x, inverse_inertia_B.y), inverse_inertia_B.z);
  return differences.are_none() & (least > btScalar(0.0));
}

struct Found {
  BlockLanes in_place;  // as written, but perhaps for the angular velocity, and finite
  BlockLanes free_to_turn;
  BlockLanes kicked;  // with another angular velocity
};

POLHODE_FOR_EACH_INSTRUCTION_SET
void begin(const Block& block, btScalar dt, Found& found, LaneTurn& turn) noexcept {
  const LaneBasis basis = load_world_bases(block);
  const BulletRows inverse_inertia_B = load_inverse_inertia_B(block);
  BulletDifferences differences;
  add_differences(basis, to_bullet(Matrix3L(block.load_q_WB().toRotationMatrix())), differences);
  add_differences(inverse_inertia_B, block.load(&BodyNumbers::inverse_inertia_B), differences);
  const BulletRows omega_W = load_omega_W(block);
  const BulletRows force_W = load_force_W(block);
  const BulletRows torque_W = load_torque_W(block);
  const BulletRows origin = block.load(origin_of);
  const BulletRows velocity = load_linear_velocity(block);
  found.in_place =
      differences.are_none().bits() & are_surely_finite(omega_W, velocity, origin, force_W, torque_W).bits();
  if (!found.in_place.all()) return;

  BulletDifferences kicks;
  add_differences(omega_W, to_bullet(block.load(&BodyNumbers::omega_W)), kicks);
  found.kicked = ~kicks.are_none().bits();
  found.free_to_turn = turn_freely(block, inverse_inertia_B, torque_W).bits();
  turn = begin_turn(basis, omega_W, dt);
  block.store(moved(origin, velocity, dt), interpolated_origin_of);
  BulletDifferences differences_of_place;
  add_differences(origin, block.load(&BodyNumbers::origin), differences_of_place);
  add_differences(velocity, block.load(&BodyNumbers::linear_velocity), differences_of_place);
  // Written only if they differ: a line of the cache that is written has to go back to memory.
  if (all(differences_of_place.are_none())) return;
  block.store(origin, &BodyNumbers::origin);
  block.store(velocity, &BodyNumbers::linear_velocity);
}

using Bodies = std::array<btRigidBody*, kLanes>;

POLHODE_FOR_EACH_INSTRUCTION_SET
void complete_turns(const Bodies* bodies, LaneTurn* turns, std::size_t count, btScalar dt) noexcept {
  for (std::size_t i = 0; i < count; ++i) take_sine_and_cosine(turns[i]);
  for (std::size_t i = 0; i < count; ++i) {
    BulletMask is_turned;  // they all are: their bases are rotations
    store_bases(
        end_turn(turns[i], dt, is_turned), [&](std::size_t lane) -> auto& {
          return interpolated_basis_of(*bodies[i][lane]);
        });
  }
}

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
void read(const Block& block, btScalar dt, const BulletRows& solved_W, Start& start) {
  set_orientation(start.state, block.load_q_WB());
  start.state.omega_W = block.load(&BodyNumbers::omega_W);
  start.state.L_W = block.load(&BodyNumbers::L_W);
  start.input.inertia_B = to_double(block.load(&BodyNumbers::inverse_inertia_B)).cwiseInverse();
  start.input.delta_omega_W = to_double(solved_W) - to_double(to_bullet(start.state.omega_W));
  start.input.dt = double(dt);
  start.input.turn_dt = double(dt);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void start_left_out(const Block& block, btScalar dt, Start& start) noexcept {
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
void start_made(const Block& block, btScalar dt, Start& start) noexcept {
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
bool write(const Block& block, const End& end, bool tensors_too) noexcept {
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

Predictions::Begun Predictions::begin(const BodyBlock& block, btScalar dt) {
  if (count_ == kBlocks) complete(dt);
  const Block loaded(block);
  Found found;
  polhode::begin(loaded, dt, found, turns_[count_]);
  if (!found.in_place.all()) return {false, {}};
  if (found.kicked.any()) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (found.kicked[lane]) block.bodies[lane]->take_over_changes();
    }
  }
  bodies_[count_] = loaded.bodies;
  ++count_;
  return {true, found.free_to_turn};
}

void Predictions::complete(btScalar dt) {
  complete_turns(bodies_.data(), turns_.data(), count_, dt);
  count_ = 0;
}

BlockLanes step_untouched(const BodyBlock& bodies, BulletsTurn bullets_turn, const LaneScheme& scheme,
                          btScalar dt) {
  const Block block(bodies);
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
