#include "bullet/batch/stages.h"
#include "bullet/internals/private_members.h"
#include "math/sine_cosine.h"
#include "polhode/rotation_math.h"
#include "simd/instruction_sets.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Agrees with formulas::turn_like_bullet up to rounding, without its sine, cosine and division by the speed.
// Beyond the limit, Bullet takes sine and cosine of the limit, keeps the length of omega, and then
// normalizes.
POLHODE_INLINE QuaternionWide predicted_q_WB(const QuaternionWide& q_WB, const Vector3Wide& omega_W,
                                             const Wide& dt) {
  const Wide half_angle2 = omega_W.squaredNorm() * (0.25 * dt * dt);
  const auto [sinc, cosine] =
      formulas::sinc_cosine_series<8>(min(half_angle2, Wide(0.25 * kBulletTurnLimit * kBulletTurnLimit)));
  const Vector3Wide vector = omega_W * (0.5 * dt * sinc);
  return formulas::normalized(QuaternionWide(cosine, vector.x(), vector.y(), vector.z()) * q_WB);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void predict_poses(const Batch& batch, const BodyPointers& bodies, btScalar dt) noexcept {
  const Vector3Wide omega_W = to_double(gather(bodies, angular_velocity));
  const QuaternionWide turned_q_WB = predicted_q_WB(batch.q_WB, omega_W, Wide(static_cast<double>(dt)));
  const BulletRows place = gather(bodies, origin);
  const BulletRows velocity = gather(bodies, linear_velocity);
  const BulletRows moved = {place.x + velocity.x * dt, place.y + velocity.y * dt, place.z + velocity.z * dt};
  scatter_transform(to_bullet(Matrix3Wide(turned_q_WB.toRotationMatrix())), moved, bodies,
                    interpolation_pose);
}

void damp(btRigidBody& body, btScalar dt) {
  const bool is_damped = body.getLinearDamping() != btScalar(0) || body.getAngularDamping() != btScalar(0) ||
                         has_additional_damping(body);
  if (is_damped) body.applyDamping(dt);
}

}  // namespace

LaneBits predict(Batch& batch, const StepContext& context) noexcept {
  LaneBits lanes;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    btRigidBody* body = batch.bodies[lane];
    lanes.set(lane, body != nullptr && !batch.diverged[lane] && moves(*body));
    if (!lanes[lane]) continue;
    damp(*body, context.dt);
    batch.may_be_clamped.set(lane, body->getCcdSquareMotionThreshold() != btScalar(0));
    // Bullet's loop resets the fraction, but may skip this body.
    if (batch.may_be_clamped[lane]) body->setHitFraction(btScalar(1));
  }
  if (lanes.none()) return lanes;
  begin_step(batch, lanes, context);
  predict_poses(batch, body_pointers(batch, lanes, context.bullet.placeholder()), context.dt);
  return lanes;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
