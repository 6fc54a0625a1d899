#include "lanes/mean_angular_velocity.h"

#include <algorithm>
#include <array>

#include "lanes/instruction_sets.h"
#include "polhode/rotation_math.h"

namespace polhode {

namespace {

// Up to this square of the half turn's sine (a turn of half a radian) the terms left out of the series are
// under 1e-18.
constexpr double kSeriesSine2 = 0.05;

// asin(s)/s = sum of kArcSine[i] s^(2i)
constexpr std::array<double, 13> kArcSine = {1.0,
                                             1.0 / 6.0,
                                             3.0 / 40.0,
                                             5.0 / 112.0,
                                             35.0 / 1152.0,
                                             63.0 / 2816.0,
                                             231.0 / 13312.0,
                                             143.0 / 10240.0,
                                             6435.0 / 557056.0,
                                             12155.0 / 1245184.0,
                                             46189.0 / 5505024.0,
                                             88179.0 / 12058624.0,
                                             676039.0 / 104857600.0};

// sum of kArcSine[first + 3 i] y^i
Lanes every_third_term(std::size_t first, const Lanes& y) {
  Lanes sum = kArcSine[first + 9];
  for (std::size_t i = first + 9; i >= 3; i -= 3) sum = sum * y + kArcSine[i - 3];
  return sum;
}

// By three sums side by side, of which none waits for another.
Lanes arc_sine_series(const Lanes& x) {
  const Lanes x2 = x * x;
  const Lanes y = x * x2;
  const Lanes first = every_third_term(0, y) + (y * y) * (y * y) * kArcSine[12];
  return first + (x * every_third_term(1, y) + x2 * every_third_term(2, y));
}

Quaternion in_lane(std::size_t lane, const QuaternionL& q) {
  return {q.w()[lane], q.x()[lane], q.y()[lane], q.z()[lane]};
}

void set_lane(std::size_t lane, const Quaternion& q, QuaternionL& result) {
  for (int i = 0; i < 4; ++i) result.coeffs()[i].set(lane, q.coeffs()[i]);
}

}  // namespace

// With s the sine of half the turn, 2 asin(s)/s times the turn's vector part.
POLHODE_FOR_EACH_INSTRUCTION_SET
void mean_angular_velocities_W(const QuaternionL& start_q_WB, const QuaternionL& end_q_WB, double dt,
                               Vector3L& result) noexcept {
  const QuaternionL turn_W = end_q_WB * start_q_WB.conjugate();
  const Lanes sine2 = turn_W.vec().squaredNorm();
  const Lanes factor =
      select(turn_W.w() < Lanes(0.0), Lanes(-2.0 / dt), Lanes(2.0 / dt)) * arc_sine_series(sine2);
  result = turn_W.vec() * factor;
  const std::bitset<kLanes> are_small = (sine2 <= kSeriesSine2).bits();
  if (are_small.all()) return;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (are_small[lane]) continue;
    const Vector3 omega_W = logarithm(in_lane(lane, end_q_WB) * in_lane(lane, start_q_WB).conjugate()) / dt;
    for (int i = 0; i < 3; ++i) result[i].set(lane, omega_W[i]);
  }
}

void mean_angular_velocities_W(const OrientationPair* pairs, std::size_t count, double dt,
                               Vector3* results) noexcept {
  for (std::size_t first = 0; first < count; first += kLanes) {
    QuaternionL start_q_WB;
    QuaternionL end_q_WB;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const OrientationPair& pair = pairs[std::min(first + lane, count - 1)];
      set_lane(lane, *pair.start_q_WB, start_q_WB);
      set_lane(lane, *pair.end_q_WB, end_q_WB);
    }
    Vector3L omega_W;
    mean_angular_velocities_W(start_q_WB, end_q_WB, dt, omega_W);
    for (std::size_t lane = 0; lane < kLanes && first + lane < count; ++lane) {
      results[first + lane] = {omega_W[0][lane], omega_W[1][lane], omega_W[2][lane]};
    }
  }
}

}  // namespace polhode
