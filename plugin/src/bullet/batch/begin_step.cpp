#include "bullet/batch/stages.h"
#include "bullet/body/external_changes.h"
#include "bullet/body/locked_axes.h"
#include "bullet/body/non_finite.h"
#include "simd/instruction_sets.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

struct Found {
  LaneBits changed;  // other changes than of velocity since the library last wrote the body
  LaneBits kicked;   // changes of velocity
  LaneBits finite;
  LaneBits held;
};

POLHODE_FOR_EACH_INSTRUCTION_SET
void compare_with_written(const BodyPointers& bodies, const LaneBits& lanes, Batch& batch,
                          Found& found) noexcept {
  BulletDifferences differences;
  add_differences(gather_basis(bodies, basis), to_bullet(Matrix3Wide(batch.q_WB.toRotationMatrix())),
                  differences);
  const BulletRows inverse_B = gather(bodies, inverse_inertia_B);
  add_differences(inverse_B, batch.inverse_inertia_B, differences);
  found.changed = ~differences.are_none().lanes();
  const BulletRows omega_W = gather(bodies, angular_velocity);
  BulletDifferences differences_of_velocity;
  add_differences(omega_W, batch.written_omega_W, differences_of_velocity);
  found.kicked = ~differences_of_velocity.are_none().lanes();
  const BulletRows place = gather(bodies, origin);
  const BulletRows torque_W = gather(bodies, total_torque);
  const BulletMask finite = are_surely_finite(omega_W, gather(bodies, linear_velocity), place,
                                              gather(bodies, total_force), torque_W);
  found.finite = finite.lanes();
  const BulletMask no_torque =
      (torque_W.x == btScalar(0)) & (torque_W.y == btScalar(0)) & (torque_W.z == btScalar(0));
  batch.torqued = (batch.torqued & ~lanes) | (lanes & ~no_torque.lanes());
  batch.origin = select(finite & bullet_mask(lanes), place, batch.origin);
  found.held = are_held(inverse_B, gather(bodies, angular_factor)).lanes();
}

// Does adopt_external_changes for lanes in which only the velocity changed.
POLHODE_FOR_EACH_INSTRUCTION_SET
void adopt_kicks(const BodyPointers& bodies, const LaneBits& lanes, Batch& batch) noexcept {
  const BulletRows omega_W = gather(bodies, angular_velocity);
  const Vector3Wide kicked_W =
      velocity_after_kick(to_double(omega_W), to_double(batch.written_omega_W), batch.omega_W);
  const Vector3Wide L_W =
      batch.R_WB == nullptr
          ? formulas::times_inertia_W(Matrix3Wide(batch.q_WB.toRotationMatrix()), batch.inertia_B(), kicked_W)
          : formulas::angular_momentum_W(*batch.R_WB, batch.inertia_B(), kicked_W);
  const WideMask mask = wide_mask(lanes);
  batch.omega_W = select(mask, kicked_W, batch.omega_W);
  batch.L_W = select(mask, L_W, batch.L_W);
  batch.written_omega_W = select(bullet_mask(lanes), omega_W, batch.written_omega_W);
}

// Bullet has multiplied the velocity by the damping factor, which is not an external change. If the factor
// makes a velocity infinite (a damping of 1 in a step back in time), the lane keeps its values: sanitize then
// restores the velocity last written.
POLHODE_FOR_EACH_INSTRUCTION_SET
void scale_velocity(const LaneBits& damped, const BulletWide& factor, const Vector3Wide& damped_L_W,
                    Batch& batch) noexcept {
  const BulletRows& written_W = batch.written_omega_W;
  const BulletRows damped_W = {written_W.x * factor, written_W.y * factor, written_W.z * factor};
  const LaneBits lanes = damped & are_surely_finite(damped_W).lanes();
  batch.written_omega_W = select(bullet_mask(lanes), damped_W, written_W);
  const WideMask mask = wide_mask(lanes);
  const Wide factor_of_state = Wide::converted(factor);
  batch.omega_W = select(mask, Vector3Wide(batch.omega_W * factor_of_state), batch.omega_W);
  batch.L_W = select(mask, damped_L_W, batch.L_W);
}

// Damping slows the body but not its rotors: L = f (L - R h) + R h.
Vector3Wide damped_momentum_W(const Batch& batch, const Wide& factor) {
  if (batch.driven == nullptr) return batch.L_W * factor;
  const WideState state = batch.wide_state();
  return with_rotor(state, Vector3Wide(without_rotor(state, state.L_W) * factor));
}

void adopt_damping(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  LaneBits damped;
  BulletWide factor = btScalar(1);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane] || batch.bodies[lane]->getAngularDamping() == btScalar(0)) continue;
    damped.set(lane);
    factor.set(lane, context.bullet.damping_factor(batch.bodies[lane]->getAngularDamping(), context.dt));
  }
  if (damped.none()) return;
  scale_velocity(damped, factor, damped_momentum_W(batch, Wide::converted(factor)), batch);
}

void take_over(Batch& batch, std::size_t lane) {
  btRigidBody& body = *batch.bodies[lane];
  if (!is_finite(body)) batch.sanitize(lane);
  set_vector_in_lane(lane, body.getWorldTransform().getOrigin(), batch.origin);
  adopt_external_changes(batch, lane);
}

}  // namespace

void adopt_changes(Batch& batch, const LaneBits& lanes, const StepContext& context) {
  const BodyPointers bodies = body_pointers(batch, lanes, context.bullet.placeholder());
  Found found;
  compare_with_written(bodies, lanes, batch, found);
  LaneBits only_kicked = lanes & found.kicked & found.finite & ~found.changed & ~found.held;
  if (batch.driven != nullptr) only_kicked = LaneBits();  // adopt_kicks ignores the rotors' momentum
  const LaneBits others = lanes & (found.changed | found.kicked | ~found.finite) & ~only_kicked;
  if (only_kicked.any()) adopt_kicks(bodies, only_kicked, batch);
  for (std::size_t lane = 0; lane < kLanes && others.any(); ++lane) {
    if (others[lane]) take_over(batch, lane);
  }
  batch.held = (batch.held & ~lanes) | (found.held & lanes);
}

void begin_step(Batch& batch, const LaneBits& lanes, const StepContext& context) noexcept {
  adopt_damping(batch, lanes, context);
  adopt_changes(batch, lanes, context);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    if (batch.steps[lane] == 0 && !batch.state_was_set[lane]) batch.start(lane);
    batch.world_index[lane] = batch.bodies[lane]->getWorldArrayIndex();
  }
  batch.begun |= lanes;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
