#include "bullet/batch/predict.h"

#include "bullet/internals/private_members.h"
#include "simd/instruction_sets.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Returns the lanes whose pose is the one written last; the others' prediction is to be made anew.
POLHODE_FOR_EACH_INSTRUCTION_SET
void predict_poses(const Batch& batch, const BodyPointers& bodies, btScalar dt,
                   LaneBits& as_written) noexcept {
  BulletDifferences differences;
  add_differences(gather_basis(bodies, basis), to_bullet(Matrix3Wide(batch.q_WB.toRotationMatrix())),
                  differences);
  as_written = differences.are_none().bits();
  const Vector3Wide omega_W = to_double(gather(bodies, angular_velocity));
  const QuaternionWide turned_q_WB =
      formulas::turn_like_bullet(batch.q_WB, omega_W, Wide(static_cast<double>(dt)));
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
    lanes[lane] = body != nullptr && !batch.diverged[lane] && !body->isStaticOrKinematicObject();
    if (!lanes[lane]) continue;
    damp(*body, context.dt);
    batch.may_be_clamped[lane] = body->getCcdSquareMotionThreshold() != btScalar(0);
    if (batch.may_be_clamped[lane]) body->setHitFraction(btScalar(1));  // as Bullet's loop, which may skip it
  }
  if (lanes.none()) return lanes;
  const BodyPointers bodies = body_pointers(batch, lanes, context.bullet.nobody());
  LaneBits as_written;
  predict_poses(batch, bodies, context.dt, as_written);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane] || as_written[lane]) continue;
    bodies[lane]->predictIntegratedTransform(context.dt, bodies[lane]->getInterpolationWorldTransform());
  }
  return lanes;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
