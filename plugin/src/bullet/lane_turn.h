#pragma once

#include <LinearMath/btTransformUtil.h>

#include "bullet/bullet_lanes.h"

/// Bullet's turn of eight bodies. The formulas are those of Bullet 3.24, without its SSE paths, operation by
/// operation in the same order: LinearMath/btTransformUtil.h (integrateTransform), btMatrix3x3.h
/// (getRotation, setRotation) and btQuaternion.h (operator*, safeNormalize). A choice between two results
/// stands for a branch.
namespace polhode {
inline namespace POLHODE_PRECISION {

struct LaneQuaternion {
  BulletLanes x, y, z, w;
};

/// The turn in three parts: the sines are taken one by one, of several blocks of bodies at once, so that what
/// is computed next need not wait for what was last.
struct LaneTurn {
  BulletRows omega_W;
  LaneQuaternion q_WB;
  BulletLanes angular_speed;
  BulletLanes sine;    // at first the angle
  BulletLanes cosine;  // likewise, multiplied in another order, as Bullet does
};

// btMatrix3x3::getRotation
inline LaneQuaternion rotation_of(const LaneBasis& m) {
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

/// integrateTransform, up to where it takes the sine and the cosine.
inline LaneTurn begin_turn(const LaneBasis& basis, const BulletRows& omega_W, btScalar dt) {
  const BulletLanes speed2 = omega_W.x * omega_W.x + omega_W.y * omega_W.y + omega_W.z * omega_W.z;
  BulletLanes speed = select(speed2 > SIMD_EPSILON, sqrt(speed2), btScalar(0.0));
  const btScalar greatest = ANGULAR_MOTION_THRESHOLD / dt;
  speed = select(speed * dt > ANGULAR_MOTION_THRESHOLD, greatest, speed);
  return {omega_W, rotation_of(basis), speed, btScalar(0.5) * speed * dt, speed * dt * btScalar(0.5)};
}

inline void take_sine_and_cosine(LaneTurn& turn) {
  turn.sine = in_each_lane(turn.sine, [](btScalar angle) { return btSin(angle); });
  turn.cosine = in_each_lane(turn.cosine, [](btScalar angle) { return btCos(angle); });
}

// integrateTransform's dorn.
inline LaneQuaternion turn_W_of(const LaneTurn& turn, btScalar dt) {
  const BulletLanes& speed = turn.angular_speed;
  const BulletLanes series = btScalar(0.5) * dt - (dt * dt * dt) * btScalar(0.020833333333) * speed * speed;
  const BulletLanes factor = select(speed < btScalar(0.001), series, turn.sine / speed);
  return {turn.omega_W.x * factor, turn.omega_W.y * factor, turn.omega_W.z * factor, turn.cosine};
}

inline LaneQuaternion product(const LaneQuaternion& a, const LaneQuaternion& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
          a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

inline BulletLanes length2(const LaneQuaternion& q) {
  return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}

inline LaneQuaternion safe_normalized(const LaneQuaternion& q) {
  const BulletLanes square = length2(q);
  const BulletLanes factor = btScalar(1.0) / sqrt(square);
  const BulletMask is_safe = square > SIMD_EPSILON;
  return {select(is_safe, q.x * factor, q.x), select(is_safe, q.y * factor, q.y),
          select(is_safe, q.z * factor, q.z), select(is_safe, q.w * factor, q.w)};
}

// btMatrix3x3::setRotation
inline LaneBasis basis_of(const LaneQuaternion& q, const BulletLanes& length2_of_q) {
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

/// integrateTransform, from where it has the sine and the cosine. Where not `is_turned` Bullet leaves the
/// basis as it is.
inline LaneBasis end_turn(const LaneTurn& turn, btScalar dt, BulletMask& is_turned) {
  const LaneQuaternion q_WB = safe_normalized(product(turn_W_of(turn, dt), turn.q_WB));
  const BulletLanes square = length2(q_WB);
  is_turned = square > SIMD_EPSILON;
  return basis_of(q_WB, square);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
