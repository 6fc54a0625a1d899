#include "lanes/mean_angular_velocity.h"

#include <algorithm>
#include <array>

#include "lanes/instruction_sets.h"
#include "lanes/lanes.h"
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

QuaternionL load(const OrientationPair* pairs, std::size_t count,
                 const Quaternion* OrientationPair::*orientation) {
  QuaternionL result;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Quaternion& q_WB = *(pairs[std::min(lane, count - 1)].*orientation);
    for (int i = 0; i < 4; ++i) result.coeffs()[i].set(lane, q_WB.coeffs()[i]);
  }
  return result;
}

// With s the sine of half the turn, 2 asin(s)/s times the turn's vector part.
void step_block(const OrientationPair* pairs, std::size_t count, double dt, Vector3* results) {
  const QuaternionL turn_W = load(pairs, count, &OrientationPair::end_q_WB) *
                             load(pairs, count, &OrientationPair::start_q_WB).conjugate();
  const Lanes sine2 = turn_W.vec().squaredNorm();
  Lanes series = kArcSine.back();
  for (std::size_t i = kArcSine.size() - 1; i-- > 0;) series = series * sine2 + kArcSine[i];
  const Lanes factor = select(turn_W.w() < Lanes(0.0), Lanes(-2.0 / dt), Lanes(2.0 / dt)) * series;
  for (std::size_t lane = 0; lane < count; ++lane) {
    const Vector3 vector_W(turn_W.x()[lane], turn_W.y()[lane], turn_W.z()[lane]);
    results[lane] =
        sine2[lane] <= kSeriesSine2
            ? Vector3(vector_W * factor[lane])
            : Vector3(logarithm(*pairs[lane].end_q_WB * pairs[lane].start_q_WB->conjugate()) / dt);
  }
}

}  // namespace

POLHODE_FOR_EACH_INSTRUCTION_SET
void mean_angular_velocities_W(const OrientationPair* pairs, std::size_t count, double dt,
                               Vector3* results) noexcept {
  for (std::size_t first = 0; first < count; first += kLanes) {
    step_block(pairs + first, std::min(kLanes, count - first), dt, results + first);
  }
}

}  // namespace polhode
