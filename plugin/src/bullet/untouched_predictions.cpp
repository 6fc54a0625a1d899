#include "bullet/untouched_predictions.h"

#include "bullet/block_rows.h"
#include "lanes/instruction_sets.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

struct Found {
  BlockLanes in_place;  // as written, but perhaps for the angular velocity, and finite
  BlockLanes free_to_turn;
  BlockLanes kicked;  // with another angular velocity
};

POLHODE_FOR_EACH_INSTRUCTION_SET
void begin(const BlockRows& block, btScalar dt, Found& found, LaneTurn& turn) noexcept {
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

}  // namespace

UntouchedPredictions::Begun UntouchedPredictions::begin(const BodyBlock& block, btScalar dt) {
  if (count_ == kBlocks) complete(dt);
  const BlockRows rows(block);
  Found found;
  polhode::begin(rows, dt, found, turns_[count_]);
  if (!found.in_place.all()) return {found.in_place, {}};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (found.kicked[lane]) block.bodies[lane]->take_over_changes();
  }
  bodies_[count_] = rows.bodies;
  ++count_;
  return {found.in_place, found.free_to_turn};
}

void UntouchedPredictions::complete(btScalar dt) {
  complete_turns(bodies_.data(), turns_.data(), count_, dt);
  count_ = 0;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
