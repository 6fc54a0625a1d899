#include "bullet/turns_together.h"

#include <algorithm>
#include <array>

#include "bullet/bullet_trials.h"
#include "bullet/lane_turn.h"
#include "lanes/instruction_sets.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

constexpr std::size_t kBlocks = 4;  // see LaneTurn
constexpr std::size_t kBodies = kBlocks * kLanes;

// A block is `turns` of eight bodies.
BulletRows load_omega_W(const BasisTurn* turns) {
  return load_vectors([turns](std::size_t lane) -> auto& { return *turns[lane].omega_W; });
}

LaneBasis load_basis(const BasisTurn* turns) {
  return load_bases([turns](std::size_t lane) -> auto& { return *turns[lane].basis; });
}

void store_basis(const BasisTurn* turns, const LaneBasis& turned, const BulletMask& is_turned) {
  if (all(is_turned)) {
    store_bases(
        turned, [turns](std::size_t lane) -> auto& { return *turns[lane].result; });
    return;
  }
  std::array<btMatrix3x3, kLanes> results;
  store_bases(
      turned, [&results](std::size_t lane) -> auto& { return results[lane]; });
  const std::bitset<kLanes> turned_lanes = is_turned.bits();
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    *turns[lane].result = turned_lanes[lane] ? results[lane] : *turns[lane].basis;
  }
}

// As many blocks, up to kBlocks.
void turn_blocks(const BasisTurn* turns, std::size_t blocks, btScalar dt) {
  std::array<LaneTurn, kBlocks> lane_turns;
  for (std::size_t i = 0; i < blocks; ++i) {
    const BasisTurn* block = turns + i * kLanes;
    lane_turns[i] = begin_turn(load_basis(block), load_omega_W(block), dt);
  }
  for (std::size_t i = 0; i < blocks; ++i) take_sine_and_cosine(lane_turns[i]);
  for (std::size_t i = 0; i < blocks; ++i) {
    BulletMask is_turned;
    const LaneBasis turned = end_turn(lane_turns[i], dt, is_turned);
    store_basis(turns + i * kLanes, turned, is_turned);
  }
}

// Fewer than eight; the last one fills the lanes that are left.
void turn_rest(const BasisTurn* turns, std::size_t count, btScalar dt) {
  btMatrix3x3 nobodys;
  std::array<BasisTurn, kLanes> block;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    block[lane] = turns[std::min(lane, count - 1)];
    if (lane >= count) block[lane].result = &nobodys;
  }
  turn_blocks(block.data(), 1, dt);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void turn_in_lanes(const BasisTurn* turns, std::size_t count, btScalar dt) noexcept {
  const std::size_t whole = count - count % kLanes;
  for (std::size_t first = 0; first < whole; first += kBodies) {
    turn_blocks(turns + first, std::min(kBodies, whole - first) / kLanes, dt);
  }
  if (whole < count) turn_rest(turns + whole, count - whole, dt);
}

bool turns_agree_with_bullet(Trials& trials, BulletReplay& replay) {
  std::array<btMatrix3x3, kLanes> bases;
  std::array<btVector3, kLanes> omegas_W;
  std::array<btMatrix3x3, kLanes> results;
  std::array<BasisTurn, kLanes> turns;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    bases[lane] = trials.basis();
    omegas_W[lane] = trials.omega_W();
    turns[lane] = {&bases[lane], &omegas_W[lane], &results[lane]};
  }
  const btScalar dt = trials.dt();
  turn_in_lanes(turns.data(), kLanes, dt);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!same_bits(results[lane], replay.turned(bases[lane], omegas_W[lane], dt))) return false;
  }
  return true;
}

}  // namespace

bool turns_in_lanes() {
  static const bool result = agrees_each_time(40, turns_agree_with_bullet);
  return result;
}

void turn_like_bullet(const BasisTurn* turns, std::size_t count, btScalar dt, BulletReplay& replay) {
  if (turns_in_lanes()) {
    turn_in_lanes(turns, count, dt);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    *turns[i].result = replay.turned(*turns[i].basis, *turns[i].omega_W, dt);
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
