#include "bullet/turns_together.h"

#include <LinearMath/btTransformUtil.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>

#include "lanes/instruction_sets.h"
#include "lanes/lane_rows.h"

// The formulas are those of Bullet 3.24, without its SSE paths, operation by operation in the same order:
// LinearMath/btTransformUtil.h (integrateTransform), btMatrix3x3.h (getRotation, setRotation) and
// btQuaternion.h (operator*, safeNormalize). A choice between two results stands for a branch.
namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

using BulletLanes = BasicLanes<RegistersOf<btScalar>>;
using BulletMask = BulletLanes::Mask;
using BulletRows = LaneRows<btScalar>;

// Of so many the half angles are computed before the sines, and these before the rest: what is computed next
// then need not wait for what was last.
constexpr std::size_t kBlocks = 4;
constexpr std::size_t kBodies = kBlocks * kLanes;

struct LaneQuaternion {
  BulletLanes x, y, z, w;
};

struct LaneBasis {
  BulletRows x, y, z;
};

struct HalfTurn {
  BulletLanes angular_speed;
  BulletLanes sine;    // at first the angle
  BulletLanes cosine;  // likewise, multiplied in another order, as Bullet does
};

// A block is `turns` of eight bodies.
BulletRows load_omega_W(const BasisTurn* turns) {
  return load_rows<btScalar>([turns](std::size_t lane) { return turns[lane].omega_W->m_floats; });
}

LaneBasis load_basis(const BasisTurn* turns) {
  const auto row = [turns](int i) {
    return load_rows<btScalar>([turns, i](std::size_t lane) { return (*turns[lane].basis)[i].m_floats; });
  };
  return {row(0), row(1), row(2)};
}

void store_rows_of(const BasisTurn* turns, const LaneBasis& turned) {
  const auto store_row = [turns](int i, const BulletRows& row) {
    store_rows(row, [turns, i](std::size_t lane) { return (*turns[lane].result)[i].m_floats; });
  };
  store_row(0, turned.x);
  store_row(1, turned.y);
  store_row(2, turned.z);
}

void store_basis(const BasisTurn* turns, const LaneBasis& turned, const BulletMask& is_turned) {
  if (all(is_turned)) {
    store_rows_of(turns, turned);
    return;
  }
  std::array<btMatrix3x3, kLanes> results;
  std::array<BasisTurn, kLanes> aside;
  for (std::size_t lane = 0; lane < kLanes; ++lane) aside[lane].result = &results[lane];
  store_rows_of(aside.data(), turned);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    *turns[lane].result = is_turned[lane] ? results[lane] : *turns[lane].basis;
  }
}

// integrateTransform, up to where it takes the sine and the cosine.
HalfTurn half_turn_before_sine(const BulletRows& omega_W, btScalar dt) {
  const BulletLanes speed2 = omega_W.x * omega_W.x + omega_W.y * omega_W.y + omega_W.z * omega_W.z;
  HalfTurn result;
  BulletLanes& speed = result.angular_speed;
  speed = select(speed2 > SIMD_EPSILON, sqrt(speed2), btScalar(0.0));
  const btScalar greatest = ANGULAR_MOTION_THRESHOLD / dt;
  speed = select(speed * dt > ANGULAR_MOTION_THRESHOLD, greatest, speed);
  result.sine = btScalar(0.5) * speed * dt;
  result.cosine = speed * dt * btScalar(0.5);
  return result;
}

void take_sine_and_cosine(BulletLanes& sine, BulletLanes& cosine) {
  sine = in_each_lane(sine, [](btScalar angle) { return btSin(angle); });
  cosine = in_each_lane(cosine, [](btScalar angle) { return btCos(angle); });
}

// integrateTransform's dorn.
LaneQuaternion turn_W_of(const BulletRows& omega_W, const HalfTurn& half_turn, btScalar dt) {
  const BulletLanes& speed = half_turn.angular_speed;
  const BulletLanes series = btScalar(0.5) * dt - (dt * dt * dt) * btScalar(0.020833333333) * speed * speed;
  const BulletLanes factor = select(speed < btScalar(0.001), series, half_turn.sine / speed);
  return {omega_W.x * factor, omega_W.y * factor, omega_W.z * factor, half_turn.cosine};
}

// btMatrix3x3::getRotation
LaneQuaternion rotation_of(const LaneBasis& m) {
  const BulletLanes trace = m.x.x + m.y.y + m.z.z;
  const BulletMask is_w = trace > btScalar(0.0);
  const BulletMask x_below_y = m.x.x < m.y.y, y_below_z = m.y.y < m.z.z, x_below_z = m.x.x < m.z.z;
  // By nested choices: of masks that are combined first GCC 12 takes each number apart.
  const auto of_greatest = [&](const BulletLanes& w, const BulletLanes& x, const BulletLanes& y,
                               const BulletLanes& z) {
    return select(is_w, w, select(x_below_y, select(y_below_z, z, y), select(x_below_z, z, x)));
  };
  const BulletLanes root =
      sqrt(of_greatest(trace, m.x.x - m.y.y - m.z.z, m.y.y - m.z.z - m.x.x, m.z.z - m.x.x - m.y.y) +
           btScalar(1.0));
  const BulletLanes greatest = root * btScalar(0.5);
  const BulletLanes factor = btScalar(0.5) / root;
  const BulletLanes difference_x = (m.z.y - m.y.z) * factor;
  const BulletLanes difference_y = (m.x.z - m.z.x) * factor;
  const BulletLanes difference_z = (m.y.x - m.x.y) * factor;
  const BulletLanes sum_xy = (m.y.x + m.x.y) * factor;
  const BulletLanes sum_xz = (m.z.x + m.x.z) * factor;
  const BulletLanes sum_yz = (m.z.y + m.y.z) * factor;
  return {of_greatest(difference_x, greatest, sum_xy, sum_xz),
          of_greatest(difference_y, sum_xy, greatest, sum_yz),
          of_greatest(difference_z, sum_xz, sum_yz, greatest),
          of_greatest(greatest, difference_x, difference_y, difference_z)};
}

LaneQuaternion product(const LaneQuaternion& a, const LaneQuaternion& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
          a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

BulletLanes length2(const LaneQuaternion& q) {
  return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}

LaneQuaternion safe_normalized(const LaneQuaternion& q) {
  const BulletLanes square = length2(q);
  const BulletLanes factor = btScalar(1.0) / sqrt(square);
  const BulletMask is_safe = square > SIMD_EPSILON;
  return {select(is_safe, q.x * factor, q.x), select(is_safe, q.y * factor, q.y),
          select(is_safe, q.z * factor, q.z), select(is_safe, q.w * factor, q.w)};
}

// btMatrix3x3::setRotation
LaneBasis basis_of(const LaneQuaternion& q, const BulletLanes& length2_of_q) {
  const BulletLanes s = btScalar(2.0) / length2_of_q;
  const BulletLanes xs = q.x * s, ys = q.y * s, zs = q.z * s;
  const BulletLanes wx = q.w * xs, wy = q.w * ys, wz = q.w * zs;
  const BulletLanes xx = q.x * xs, xy = q.x * ys, xz = q.x * zs;
  const BulletLanes yy = q.y * ys, yz = q.y * zs, zz = q.z * zs;
  const BulletLanes one = btScalar(1.0);
  return {{one - (yy + zz), xy - wz, xz + wy},
          {xy + wz, one - (xx + zz), yz - wx},
          {xz - wy, yz + wx, one - (xx + yy)}};
}

// integrateTransform, from where it has the sine and the cosine.
void finish_block(const BasisTurn* turns, const HalfTurn& half_turn, btScalar dt) {
  const LaneQuaternion turn_W = turn_W_of(load_omega_W(turns), half_turn, dt);
  const LaneQuaternion q_WB = safe_normalized(product(turn_W, rotation_of(load_basis(turns))));
  const BulletLanes square = length2(q_WB);
  store_basis(turns, basis_of(q_WB, square), square > SIMD_EPSILON);
}

// As many blocks, up to kBlocks.
void turn_blocks(const BasisTurn* turns, std::size_t blocks, btScalar dt) {
  std::array<HalfTurn, kBlocks> half_turns;
  for (std::size_t i = 0; i < blocks; ++i) {
    half_turns[i] = half_turn_before_sine(load_omega_W(turns + i * kLanes), dt);
  }
  for (std::size_t i = 0; i < blocks; ++i) take_sine_and_cosine(half_turns[i].sine, half_turns[i].cosine);
  for (std::size_t i = 0; i < blocks; ++i) finish_block(turns + i * kLanes, half_turns[i], dt);
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

// Deterministic poses and velocities; a few that follow one another reach every branch of Bullet's.
class Trials {
 public:
  // Those of the quaternion that are the greatest take turns, with now and then what is no rotation and what
  // exceeds the range of numbers.
  btMatrix3x3 basis() {
    ++number_;
    if (number_ % 15 == 0) return any_matrix(btScalar(0.9) * SIMD_INFINITY);
    if (number_ % 5 == 0) return any_matrix(btScalar(1.0));
    return any_rotation(number_ % 4);
  }

  btVector3 omega_W() {
    constexpr std::array<double, 7> kSpeeds = {0.0, 1e-9, 1e-4, 2e-3, 1.0, 30.0, 1e3};  // rad/s
    return any_vector() * static_cast<btScalar>(kSpeeds[number_ % kSpeeds.size()]);
  }

  btScalar dt() { return btScalar(0.02) + btScalar(0.015) * any(); }

 private:
  // Between -1 and 1.
  btScalar any() {
    return static_cast<btScalar>(2.0 * static_cast<double>(generator_()) / std::minstd_rand::max() - 1.0);
  }
  btVector3 any_vector() {
    const btScalar x = any(), y = any(), z = any();
    return {x, y, z};
  }
  btMatrix3x3 any_matrix(btScalar size) {
    const btVector3 x = any_vector() * size, y = any_vector() * size, z = any_vector() * size;
    return {x, y, z};
  }
  btMatrix3x3 any_rotation(std::size_t greatest) {
    std::array<btScalar, 4> q = {any(), any(), any(), any()};
    q[greatest] += btScalar(2.0);
    return btMatrix3x3(btQuaternion(q[0], q[1], q[2], q[3]));
  }

  std::minstd_rand generator_;
  std::size_t number_ = 0;
};

bool same_bits(const btMatrix3x3& a, const btMatrix3x3& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// Bullet may have been built in another way than its formulas are repeated here: with SSE, with relaxed
// arithmetic, with another derivative, from another version.
bool lanes_agree_with_bullet() {
  constexpr std::size_t kBlocksTried = 40;
  BulletReplay replay;
  Trials trials;
  for (std::size_t i = 0; i < kBlocksTried; ++i) {
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
  }
  return true;
}

}  // namespace

bool turns_in_lanes() {
  static const bool result = lanes_agree_with_bullet();
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
