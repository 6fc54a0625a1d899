#include "bullet/batch/write_step.h"

#include "polhode/bullet/conversions.h"
#include "polhode/rotation_limits.h"
#include "simd/instruction_sets.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

POLHODE_FOR_EACH_INSTRUCTION_SET
void find_within_limits(const WideState& state, LaneBits& result) noexcept {
  const Vector3Wide columns2(state.R_WB.col(0).squaredNorm(), state.R_WB.col(1).squaredNorm(),
                             state.R_WB.col(2).squaredNorm());
  // 0 times a finite number is 0; 0 times infinity or NaN is NaN.
  const Wide q2 = state.q_WB.coeffs().squaredNorm();
  const Wide probe = (q2 + columns2[0] + columns2[1] + columns2[2]) * Wide(0.0) +
                     Wide(state.omega_W.dot(state.L_W)) * Wide(0.0);
  const Wide longest2 = max(max(columns2[0], columns2[1]), columns2[2]);
  result = ((state.omega_W.squaredNorm() <= Wide(kMaximumAngularSpeed * kMaximumAngularSpeed)) &
            (longest2 <= Wide(kMaximumSwelling * kMaximumSwelling)) & (Wide(kMinimumQuaternionNorm2) <= q2) &
            (probe == Wide(0.0)))
               .lanes();
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void store(const LaneBits& lanes, const Solved& solved, const StepResult& result, Batch& batch) noexcept {
  const WideMask mask = wide_mask(lanes);
  const WideState& state = result.state;
  batch.q_WB = QuaternionWide(select(mask, state.q_WB.coeffs(), batch.q_WB.coeffs()));
  batch.omega_W = select(mask, state.omega_W, batch.omega_W);
  batch.L_W = select(mask, state.L_W, batch.L_W);
  const BulletMask mask_of_bullet = bullet_mask(lanes);
  batch.written_omega_W = select(mask_of_bullet, to_bullet(result.shown_W), batch.written_omega_W);
  batch.origin = select(mask_of_bullet, solved.origin, batch.origin);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void scatter_step(const Batch& batch, const BodyPointers& bodies, const BulletRows& linear_velocity,
                  const Vector3Wide& mean_W) noexcept {
  const BulletBasis bases = to_bullet(Matrix3Wide(batch.q_WB.toRotationMatrix()));
  scatter_transform(bases, batch.origin, bodies, pose);
  scatter_transform(bases, batch.origin, bodies, interpolation_pose);
  scatter_basis(inverse_inertia_basis_W(bases, batch.inverse_inertia_B), bodies, inverse_inertia_tensor_W);
  scatter(batch.written_omega_W, bodies, angular_velocity);
  scatter(linear_velocity, bodies, interpolation_linear_velocity);
  scatter(to_bullet(mean_W), bodies, interpolation_angular_velocity);
}

// Keeps velocity changes after Bullet's integration out of this step. The next step adopts them as external
// changes.
void keep_later_kicks(const Batch& batch, const LaneBits& lanes, const Solved& solved) {
  BulletDifferences differences;
  add_differences(solved.shown_later_W, solved.omega_W, differences);
  const LaneBits kicked = lanes & ~differences.are_none().lanes();
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!kicked[lane]) continue;
    const btVector3 kick_W =
        vector_in_lane(solved.shown_later_W, lane) - vector_in_lane(solved.omega_W, lane);
    batch.bodies[lane]->setAngularVelocity(vector_in_lane(batch.written_omega_W, lane) + kick_W);
  }
}

// Stops a diverged body: an unbounded spin would fling its neighbours away.
void stop(Batch& batch, std::size_t lane, const Solved& solved) {
  btRigidBody& body = *batch.bodies[lane];
  batch.diverged.set(lane);
  batch.note(lane, IncidentKind::scheme_diverged);
  body.setAngularVelocity(btVector3(0, 0, 0));
  set_vector_in_lane(lane, body.getAngularVelocity(), batch.written_omega_W);
  const Quaternion q_WB = batch.state(lane).q_WB;
  body.setCenterOfMassTransform(
      btTransform(to_bullet(Matrix3(q_WB.toRotationMatrix())), vector_in_lane(solved.origin, lane)));
}

}  // namespace

void write_step(Batch& batch, const LaneBits& lanes, PoseIntegratedBy integrator, const Solved& solved,
                const StepResult& result, const StepContext& context) {
  LaneBits good;
  find_within_limits(result.state, good);
  good &= lanes;
  store(good, solved, result, batch);
  if (batch.driven != nullptr) end_drive(batch, good, result.state);
  if (batch.R_WB != nullptr) *batch.R_WB = select(wide_mask(good), result.state.R_WB, *batch.R_WB);
  scatter_step(batch, body_pointers(batch, good, context.bullet.placeholder()), solved.linear_velocity,
               result.mean_W);
  if (integrator == PoseIntegratedBy::bullet) keep_later_kicks(batch, good, solved);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (good[lane]) {
      ++batch.steps[lane];
      if (batch.unresolved[lane]) ++batch.unresolved_steps[lane];
    } else if (lanes[lane]) {
      stop(batch, lane, solved);
    }
  }
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
