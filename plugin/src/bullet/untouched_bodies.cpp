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

POLHODE_FOR_EACH_INSTRUCTION_SET
void begin(const Block& block, btScalar dt, Predictions::Begun& begun, LaneTurn& turn) noexcept {
  const LaneBasis basis = load_world_bases(block);
  const BulletRows omega_W = load_omega_W(block);
  const BulletRows inverse_inertia_B =
      block.load([](btRigidBody & body) -> auto& { return body.getInvInertiaDiagLocal(); });
  BulletDifferences differences;
  add_differences(basis, to_bullet(Matrix3L(block.load_q_WB().toRotationMatrix())), differences);
  add_differences(omega_W, to_bullet(block.load(&BodyNumbers::omega_W)), differences);
  add_differences(inverse_inertia_B, block.load(&BodyNumbers::inverse_inertia_B), differences);
  const BulletRows force_W = block.load([](btRigidBody & body) -> auto& { return body.getTotalForce(); });
  const BulletRows torque_W = block.load([](btRigidBody & body) -> auto& { return body.getTotalTorque(); });
  const BulletRows origin = block.load(origin_of);
  const BulletRows velocity = load_linear_velocity(block);
  begun.untouched =
      differences.are_none().bits() & are_surely_finite(omega_W, velocity, origin, force_W, torque_W).bits();
  if (!begun.untouched.all()) return;

  begun.free_to_turn = turn_freely(block, inverse_inertia_B, torque_W).bits();
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

// The basis is what was written: the state's, rounded.
BulletDifferences differences_of_basis(const Block& block, const Matrix3L& R_WB) {
  BulletDifferences differences;
  add_differences(load_world_bases(block), to_bullet(R_WB), differences);
  return differences;
}

// At the end of the step.
struct Place {
  BulletRows origin;
  BulletRows velocity;
};

// As read_state and start_step.
POLHODE_FOR_EACH_INSTRUCTION_SET
void start(const Block& block, btScalar dt, LaneInput& input, LaneState& state, Place& place,
           BlockLanes& left_in_place) noexcept {
  set_orientation(state, block.load_q_WB());
  state.omega_W = block.load(&BodyNumbers::omega_W);
  state.L_W = block.load(&BodyNumbers::L_W);
  const BulletRows omega_W = load_omega_W(block);
  input.inertia_B = to_double(block.load(&BodyNumbers::inverse_inertia_B)).cwiseInverse();
  input.delta_omega_W = to_double(omega_W) - to_double(to_bullet(state.omega_W));
  input.dt = double(dt);
  input.turn_dt = double(dt);
  place.velocity = load_linear_velocity(block);
  place.origin = moved(block.load(origin_of), place.velocity, dt);
  left_in_place = differences_of_basis(block, state.R_WB).are_none().bits() &
                  are_surely_finite(omega_W, place.velocity, place.origin).bits();
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
  LaneState state;
  Vector3L mean_omega_W;
  Place place;
  bool are_rotations;
};

// As accept_step and write_step. False: a scheme has diverged, and nothing is written.
POLHODE_FOR_EACH_INSTRUCTION_SET
bool write(const Block& block, const End& end, bool tensors_too) noexcept {
  if (!within_limits(end.state, end.are_rotations).all()) return false;
  block.store_q_WB(end.state.q_WB);
  block.store(end.state.omega_W, &BodyNumbers::omega_W);
  block.store(end.state.L_W, &BodyNumbers::L_W);

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

// Where the scheme of one of them diverged.
void finish_alone(const BodyBlock& block, const End& end, btScalar dt) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    PendingStep step;
    step.bullets_turn = BulletsTurn::left_out;
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
  Begun begun;
  polhode::begin(loaded, dt, begun, turns_[count_]);
  if (begun.untouched.all()) {
    bodies_[count_] = loaded.bodies;
    ++count_;
  }
  return begun;
}

void Predictions::complete(btScalar dt) {
  complete_turns(bodies_.data(), turns_.data(), count_, dt);
  count_ = 0;
}

BlockLanes step_untouched(const BodyBlock& bodies, const LaneScheme& scheme, btScalar dt) {
  const Block block(bodies);
  LaneInput input;
  End end;
  end.are_rotations = bodies.bodies.front()->keeps_rotation();
  BlockLanes left_in_place;
  start(block, dt, input, end.state, end.place, left_in_place);
  if (!left_in_place.all()) return left_in_place;

  SchemeMemory nobodys;
  LaneMemories memories{{}, kLanes};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    memories.of[lane] = &bodies.bodies[lane]->memory_of_scheme(nobodys);
    if (!end.are_rotations) set_lane(lane, bodies.bodies[lane]->swollen_R_WB(), end.state.R_WB);
  }
  const QuaternionL start_q_WB = end.state.q_WB;
  scheme.step_lanes(input, end.state, memories);
  mean_angular_velocities_W(start_q_WB, end.state.q_WB, dt, end.mean_omega_W);
  if (!write(block, end, inertia_tensors_in_lanes())) {
    finish_alone(bodies, end, dt);
    return left_in_place;
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    ManagedBody& body = *bodies.bodies[lane];
    body.finish_untouched();
    if (!inertia_tensors_in_lanes()) body.address()->updateInertiaTensor();
    if (!end.are_rotations) {
      Matrix3 R_WB;
      get_lane(lane, end.state.R_WB, R_WB);
      body.set_swollen_R_WB(R_WB);
    }
  }
  return left_in_place;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
