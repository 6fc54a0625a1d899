#include "bullet/body/integrated_pose.h"

#include <algorithm>
#include <limits>

#include "bullet/body/external_changes.h"
#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// The fraction of a step at which continuous collision detection clamps a body is known only up to rounding.
// In a clamped step an external rotation smaller than this, in rad, cannot be distinguished.
constexpr double kTurnLostInClampedStep = 1e-3;
// A pose set by the application is not exactly a rounded quaternion: q_WB is the nearest one. In rad.
constexpr double kRoundingOfPose = 16.0 * std::numeric_limits<btScalar>::epsilon();

}  // namespace

bool may_be_clamped(const btRigidBody& body, btScalar dt) {
  const btScalar threshold2 = body.getCcdSquareMotionThreshold();
  if (threshold2 == btScalar(0)) return false;
  const btScalar nearly_all = btScalar(0.99);
  return !(body.getLinearVelocity().length2() * dt * dt < nearly_all * threshold2);
}

// Bullet leaves a hit fraction of 0, so the fraction is computed from the position.
double turned_fraction(const Batch& batch, std::size_t lane, btScalar dt) {
  const btRigidBody& body = *batch.bodies[lane];
  if (body.getHitFraction() != btScalar(0.0)) return 1.0;
  const Vector3 path = to_double(body.getInterpolationLinearVelocity()) * static_cast<double>(dt);
  if (path.isZero(0.0)) return 1.0;
  const Vector3 covered =
      to_double(body.getWorldTransform().getOrigin()) - to_double(vector_in_lane(batch.origin, lane));
  return std::clamp(covered.dot(path) / path.squaredNorm(), 0.0, 1.0);
}

void clamp_step(const Batch& batch, std::size_t lane, const Solved& solved, const StepContext& context,
                StepResult& result) {
  const double fraction = turned_fraction(batch, lane, context.dt);
  if (fraction == 1.0) return;
  const Vector3 inertia_B = moments_B(vector_in_lane(batch.inverse_inertia_B, lane));
  const double dt = static_cast<double>(context.dt) * fraction;
  const Vector3 change_W = to_double(vector_in_lane(solved.omega_W, lane)) -
                           to_double(vector_in_lane(batch.written_omega_W, lane));
  RotationState end;
  get_lane(lane, result.state, end);
  RotationState turned = batch.state(lane);
  const bool turns_by_solved = batch.held[lane] || result.turns_by_solved[lane];
  if (turns_by_solved) {
    Vector3 turn_W;
    get_lane(lane, result.mean_W, turn_W);
    batch.scheme->turn(turn_W, dt, turned);
  } else if (batch.turn_velocity == TurnVelocity::mean) {
    batch.step(lane, {inertia_B, change_W, dt}, turned);
  } else {
    const bool by_start = batch.turn_velocity == TurnVelocity::start;
    batch.scheme->turn(by_start ? Vector3(turned.omega_W + change_W) : end.omega_W, dt, turned);
  }
  turned.rotor_momentum_B = end.rotor_momentum_B;
  if (batch.turn_velocity == TurnVelocity::end || batch.held[lane]) {
    set_omega(turned, inertia_B, end.omega_W);
  } else {
    turned.L_W = end.L_W;
    turned.omega_W = polhode::inverse_inertia_W(turned.R_WB, inertia_B) * without_rotor(turned, end.L_W);
  }
  if (!turns_by_solved) set_lane(lane, turned.omega_W, result.shown_W);
  set_lane(lane, turned, result.state);
}

// Let w be the written pose, S Bullet's turn, e = S w the expected pose and f = S p the pose found. Then
// Bullet started from the pose p = w (e^-1 f). If Bullet did not turn the body, its turn is computed, so that
// RotationWorld and RotationPlugin give the same bits.
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
