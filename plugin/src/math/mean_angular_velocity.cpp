#include "math/mean_angular_velocity.h"

#include "math/rotation.h"
#include "simd/instruction_sets.h"

namespace polhode {

namespace {

// Largest sin^2 of half the turn for which the series of the arc sine converges; a turn of 0.45 rad.
constexpr double kSeriesSine2 = 0.05;
// If the turn at near_omega_W is below this, in rad^2, a shortest rotation vector of less than 0.45 rad is
// also the nearest: 2.6 + 0.45 < pi.
constexpr double kSmallTurn2 = 2.6 * 2.6;

// Returns the rotation vector of `turn_W` that is nearest to near_W.
POLHODE_INLINE Vector3Wide nearest_rotation_vector(const QuaternionWide& turn_W, const Vector3Wide& near_W) {
  constexpr double kTurn = 6.28318530717958647692;
  const Vector3Wide shortest_W = formulas::logarithm(turn_W);
  const Wide angle = sqrt(shortest_W.squaredNorm());
  const Wide near_angle = sqrt(near_W.squaredNorm());
  // A turn of the size of rounding has no meaningful axis.
  const WideMask has_axis = angle > 1e-15 * (4.0 + near_angle);
  const Vector3Wide axis_W =
      select(has_axis, Vector3Wide(shortest_W / angle), Vector3Wide(near_W / near_angle));
  const Wide turns =
      formulas::nearest_integer(Wide((axis_W.dot(near_W) - axis_W.dot(shortest_W)) * (1.0 / kTurn)));
  return shortest_W + axis_W * (kTurn * turns);
}

}  // namespace

// Computes 2 asin(s)/s times the vector part of the turn, s the sine of half the turn.
POLHODE_FOR_EACH_INSTRUCTION_SET
void mean_angular_velocities_W(const QuaternionWide& start_q_WB, const QuaternionWide& end_q_WB,
                               const Vector3Wide& near_omega_W, const Wide& dt,
                               Vector3Wide& result) noexcept {
  const QuaternionWide turn_W = end_q_WB * start_q_WB.conjugate();
  const Wide sine2 = turn_W.vec().squaredNorm();
  const Wide twice_per_dt = 2.0 / dt;
  const Wide factor =
      select(turn_W.w() < 0.0, Wide(-twice_per_dt), twice_per_dt) * formulas::arc_sine_series(sine2);
  result = turn_W.vec() * factor;
  const WideMask is_large =
      (sine2 > kSeriesSine2) | (near_omega_W.squaredNorm() * (dt * dt) > kSmallTurn2) | (dt == 0.0);
  if (!any(is_large)) return;
  const Vector3Wide vector_W = nearest_rotation_vector(turn_W, Vector3Wide(near_omega_W * dt));
  const Vector3Wide omega_W = select(dt == 0.0, near_omega_W, Vector3Wide(vector_W / dt));
  result = select(is_large, omega_W, result);
}

}  // namespace polhode
