#include "bullet/body/split_impulse.h"

#include <limits>

#include "bullet/body/clamped_step.h"
#include "bullet/body/external_changes.h"
#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// The fraction of a step at which continuous collision detection stopped a body is known to rounding only, so
// in such a step a smaller turn by somebody else cannot be told from it. rad.
constexpr double kTurnLostInClampedStep = 1e-3;
// A pose that the application set is no rounded quaternion: q_WB is the nearest one. rad.
constexpr double kRoundingOfPose = 16.0 * std::numeric_limits<btScalar>::epsilon();

}  // namespace

// With w the pose written, e = S w what Bullet makes of it and f = S p the pose found, S Bullet's turn, the
// pose it started from is p = w (e^-1 f). Where Bullet did not turn the body its turn is computed, so that
// both ways in give the same bits.
void adopt_split_impulse(Batch& batch, std::size_t lane, PoseIntegratedBy integrator, const Solved& solved,
                         const StepContext& context) {
  RotationState state = batch.state(lane);
  btMatrix3x3 found = batch.bodies[lane]->getWorldTransform().getBasis();
  btMatrix3x3 expected = to_bullet(Matrix3(state.q_WB.toRotationMatrix()));
  const btVector3 omega_W = vector_in_lane(solved.omega_W, lane);
  double fraction = 1.0;
  double smallest = batch.constrained[lane] ? 0.0 : kRoundingOfPose;
  if (integrator == PoseIntegratedBy::library) {
    found = context.bullet.turned(found, omega_W, context.dt);
    expected = context.bullet.turned(expected, omega_W, context.dt);
  } else {
    fraction = turned_fraction(batch, lane, context.dt);
    if (fraction < 1.0) smallest = kTurnLostInClampedStep;
    expected = context.bullet.turned(expected, omega_W, context.dt * static_cast<btScalar>(fraction));
  }
  if (same(found, expected)) return;
  const Quaternion turn_B = to_quaternion(expected).conjugate() * to_quaternion(found);
  if (logarithm(turn_B).norm() < smallest) return;
  adopt_external_rotation(turn_B, moments_B(vector_in_lane(batch.inverse_inertia_B, lane)),
                          batch.keeps_rotation, state);
  batch.set_state(lane, state);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
