#include "bullet/batch/batch.h"

#include <cmath>
#include <utility>

#include "bullet/body/external_changes.h"
#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"
#include "simd/instruction_sets.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

POLHODE_FOR_EACH_INSTRUCTION_SET
void load_state(const Batch& batch, WideState& state) noexcept {
  state.q_WB = batch.q_WB;
  state.R_WB = batch.R_WB != nullptr ? *batch.R_WB : Matrix3Wide(batch.q_WB.toRotationMatrix());
  state.omega_W = batch.omega_W;
  state.L_W = batch.L_W;
  if (batch.driven != nullptr) state.rotor_momentum_B = batch.driven->rotor_momentum_B();
}

// Calls change(lane, state) for each of the lanes.
template <class Change>
void change_lanes(const LaneBits& lanes, WideState& state, const Change& change) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    RotationState of_lane;
    get_lane(lane, state, of_lane);
    change(lane, of_lane);
    set_lane(lane, of_lane, state);
  }
}

}  // namespace

Batch::Batch(SchemePointer scheme_of_all, bool is_driven)
    : scheme(std::move(scheme_of_all)),
      wide_scheme(dynamic_cast<const WideScheme*>(scheme.get())),
      turn_velocity(scheme->description().turn_velocity),
      keeps_rotation(scheme->description().rotation != Conservation::lost) {
  const BulletRows zero = {btScalar(0), btScalar(0), btScalar(0)};
  written_omega_W = origin = zero;
  inverse_inertia_B = {btScalar(1), btScalar(1), btScalar(1)};
  q_WB = QuaternionWide(Wide(1.0), Wide(0.0), Wide(0.0), Wide(0.0));
  omega_W = L_W = Vector3Wide::Constant(Wide(0.0));
  if (is_driven) driven = std::make_unique<DrivenLanes>();
  if (!keeps_rotation) R_WB = std::make_unique<Matrix3Wide>(q_WB.toRotationMatrix());
  if (memory_rows() > 0) memory = std::make_unique<Wide[]>(memory_rows());
  for (std::size_t row = 0; row < memory_rows(); ++row) memory[row] = 0.0;
}

void Batch::attach(std::size_t lane, btRigidBody& body, Drive* drive) {
  bodies[lane] = &body;
  if (driven != nullptr) driven->drives[lane] = drive;
  identities[lane] = body_identity(body);
  diverged.reset(lane);
  state_was_set.reset(lane);
  leave_step(lane);
  may_be_clamped.set(lane);
  steps[lane] = unresolved_steps[lane] = 0;
  for (std::size_t kind = 0; kind < kIncidentKinds; ++kind) {
    to_report[kind].reset(lane);
    reported[kind].reset(lane);
  }
  start(lane);
}

void Batch::leave_step(std::size_t lane) {
  begun.reset(lane);
  in_solve.reset(lane);
  of_library.reset(lane);
}

void Batch::detach(std::size_t lane) {
  bodies[lane] = nullptr;
  if (driven != nullptr) driven->drives[lane] = nullptr;
  diverged.reset(lane);
  for (LaneBits& lanes : to_report) lanes.reset(lane);
  leave_step(lane);
  may_be_clamped.reset(lane);
}

void Batch::start(std::size_t lane) {
  const btRigidBody& body = *bodies[lane];
  const BodyMotion motion = finite_motion(body, BodyMotion());
  set_vector_in_lane(lane, motion.omega_W, written_omega_W);
  set_vector_in_lane(lane, body.getInvInertiaDiagLocal(), inverse_inertia_B);
  set_vector_in_lane(lane, motion.pose.getOrigin(), origin);
  set_motion(lane, to_quaternion(motion.pose.getBasis()), to_double(motion.omega_W));
}

void Batch::set_motion(std::size_t lane, const Quaternion& orientation_WB, const Vector3& velocity_W) {
  RotationState state;
  set_orientation(state, orientation_WB);
  state.omega_W = velocity_W;
  if (driven != nullptr) state.rotor_momentum_B = driven->drives[lane]->rotor_momentum_B;
  make_momentum_agree(moments_B(bodies[lane]->getInvInertiaDiagLocal()), keeps_rotation, state);
  set_state(lane, state);
}

void Batch::set_rotation(std::size_t lane, const Quaternion& orientation_WB, const Vector3& velocity_W) {
  btRigidBody& body = *bodies[lane];
  const btVector3 place = finite_motion(body, last_written(lane)).pose.getOrigin();
  set_motion(lane, orientation_WB, velocity_W);
  diverged.reset(lane);
  state_was_set.set(lane);
  angular_velocity(body) = to_bullet(velocity_W);
  body.setCenterOfMassTransform(btTransform(to_bullet(Matrix3(orientation_WB.toRotationMatrix())), place));
  set_vector_in_lane(lane, body.getAngularVelocity(), written_omega_W);
  set_vector_in_lane(lane, body.getInvInertiaDiagLocal(), inverse_inertia_B);
  set_vector_in_lane(lane, place, origin);
}

void Batch::move_from(const Batch& other, std::size_t from, std::size_t to) noexcept {
  set_state(to, other.state(from));
  for (std::size_t row = 0; row < memory_rows(); ++row) memory[row].set(to, other.memory[row][from]);
  for (auto rows : {&Batch::written_omega_W, &Batch::inverse_inertia_B, &Batch::origin}) {
    set_vector_in_lane(to, vector_in_lane(other.*rows, from), this->*rows);
  }
  if (driven != nullptr && other.driven != nullptr) driven->move_from(*other.driven, from, to);
  bodies[to] = other.bodies[from];
  identities[to] = other.identities[from];
  list_index[to] = other.list_index[from];
  world_index[to] = other.world_index[from];
  for (auto bits : {&Batch::diverged, &Batch::state_was_set, &Batch::begun, &Batch::in_solve, &Batch::torqued,
                    &Batch::may_be_clamped, &Batch::of_library, &Batch::constrained, &Batch::held,
                    &Batch::given_mean, &Batch::given_effective, &Batch::given_torque, &Batch::unresolved}) {
    (this->*bits).set(to, (other.*bits)[from]);
  }
  gyroscopic_flags[to] = other.gyroscopic_flags[from];
  if (other.applied_torque_W != nullptr) {
    if (BulletRows* const torque_W = make_if_null(applied_torque_W)) {
      set_vector_in_lane(to, vector_in_lane(*other.applied_torque_W, from), *torque_W);
    } else {
      given_torque.reset(to);
    }
  }
  if (other.effective != nullptr) {
    if (EffectiveInertia<Wide>* const moved = make_if_null(effective)) {
      for (int i = 0; i < 3; ++i) moved->u_W[i].set(to, other.effective->u_W[i][from]);
      for (int i = 0; i < 9; ++i) moved->M_W.coeffRef(i).set(to, other.effective->M_W.coeff(i)[from]);
    } else {
      given_mean.reset(to);
      given_effective.reset(to);
    }
  }
  if (other.held_turns != nullptr) {
    if (std::array<HeldTurn, kLanes>* const turns = make_if_null(held_turns)) {
      (*turns)[to] = (*other.held_turns)[from];
    } else {
      held.reset(to);
    }
  }
  steps[to] = other.steps[from];
  unresolved_steps[to] = other.unresolved_steps[from];
  for (std::size_t kind = 0; kind < kIncidentKinds; ++kind) {
    to_report[kind].set(to, other.to_report[kind][from]);
    reported[kind].set(to, other.reported[kind][from]);
  }
}

RotationState Batch::state(std::size_t lane) const {
  RotationState result;
  get_lane(lane, q_WB.coeffs(), result.q_WB.coeffs());
  get_lane(lane, omega_W, result.omega_W);
  get_lane(lane, L_W, result.L_W);
  if (driven != nullptr && driven->drives[lane] != nullptr)
    result.rotor_momentum_B = driven->drives[lane]->rotor_momentum_B;
  if (R_WB != nullptr) {
    get_lane(lane, *R_WB, result.R_WB);
  } else {
    result.R_WB = result.q_WB.toRotationMatrix();
  }
  return result;
}

BodyMotion Batch::last_written(std::size_t lane) const {
  const btTransform pose(to_bullet(Matrix3(state(lane).q_WB.toRotationMatrix())),
                         vector_in_lane(origin, lane));
  const btVector3& linear_velocity = bodies[lane]->getInterpolationLinearVelocity();  // as scattered
  return {pose, are_finite(linear_velocity) ? linear_velocity : btVector3(0, 0, 0),
          vector_in_lane(written_omega_W, lane)};
}

void Batch::set_state(std::size_t lane, const RotationState& state) {
  set_lane(lane, state.q_WB.coeffs(), q_WB.coeffs());
  set_lane(lane, state.omega_W, omega_W);
  set_lane(lane, state.L_W, L_W);
  if (R_WB != nullptr) set_lane(lane, state.R_WB, *R_WB);
  for (std::size_t row = 0; row < memory_rows(); ++row) memory[row].set(lane, 0.0);
}

WideState Batch::wide_state() const {
  WideState result;
  load_state(*this, result);
  return result;
}

BodyRotation Batch::rotation(std::size_t lane) const {
  RotationState now = state(lane);
  if (!diverged[lane] && is_finite(*bodies[lane])) adopt_external_changes(*this, lane, now);
  // With a velocity or moment near the largest double, L or the energy overflows. The next step stops the
  // body.
  if (!std::isfinite(now.energy())) {
    now.omega_W.setZero();
    now.L_W = with_rotor(now, Vector3::Zero());
  }
  return {now, now.energy(), steps[lane], unresolved_steps[lane], diverged[lane], scheme->description().name};
}

WideStepInput Batch::free_input(btScalar dt) const {
  return {inertia_B(), Vector3Wide::Constant(Wide(0.0)), Wide(static_cast<double>(dt))};
}

void Batch::step(const LaneBits& lanes, const WideStepInput& input, WideState& result,
                 Wide* memory_or_null) const {
  LaneBits one_by_one;
  if (driven != nullptr) one_by_one = driven->acting(lanes);
  if (wide_scheme == nullptr) one_by_one = lanes;
  if (one_by_one.none()) {
    wide_scheme->step_wide(input, wide_mask(lanes), result, memory_or_null);
    return;
  }
  WideState stepped = result;
  change_lanes(one_by_one, stepped, [&](std::size_t lane, RotationState& of_lane) {
    StepInput input_of_lane;
    get_lane(lane, input, input_of_lane);
    step(lane, input_of_lane, of_lane);
  });
  if (one_by_one != lanes) {
    const WideMask mask = wide_mask(lanes & ~one_by_one);
    wide_scheme->step_wide(input, mask, result, memory_or_null);
    stepped = select(mask, result, stepped);
  }
  result = stepped;
}

void Batch::step(std::size_t lane, const StepInput& input, RotationState& state) const {
  if (driven == nullptr || !driven->drives[lane]->acts()) {
    scheme->step(input, state);
    return;
  }
  const DrivenStep step =
      take_driven_step(*scheme, input, driven->starts[lane], *driven->drives[lane], state);
  state = step.end;
  driven->last_torques[lane] = step.last_torque;
  driven->law_failed.set(lane, step.law_failed);
}

void Batch::turn(const LaneBits& lanes, const Vector3Wide& velocity_W, btScalar dt, WideState& result) const {
  if (wide_scheme != nullptr) {
    wide_scheme->turn_wide(velocity_W, Wide(static_cast<double>(dt)), result);
    return;
  }
  change_lanes(lanes, result, [&](std::size_t lane, RotationState& of_lane) {
    Vector3 velocity_of_lane_W;
    get_lane(lane, velocity_W, velocity_of_lane_W);
    scheme->turn(velocity_of_lane_W, static_cast<double>(dt), of_lane);
  });
}

void Batch::sanitize(std::size_t lane) {
  polhode::sanitize(*bodies[lane], last_written(lane));
  note(lane, IncidentKind::non_finite_body);
}

void show(const Batch& batch, std::size_t lane, btRigidBody& body, btTransform pose) {
  btMotionState* motion_state = body.getMotionState();
  if (motion_state == nullptr || !body.isActive() || body.isStaticOrKinematicObject()) return;
  if (!batch.keeps_rotation && !batch.diverged[lane]) {
    const btMatrix3x3& basis_at_end = body.getInterpolationWorldTransform().getBasis();
    Matrix3 R_WB = batch.state(lane).R_WB;
    if (!same(pose.getBasis(), basis_at_end))
      R_WB = to_double(pose.getBasis()) * to_double(basis_at_end).transpose() * R_WB;
    pose.setBasis(to_bullet(R_WB));
  }
  motion_state->setWorldTransform(pose);
}

BodyPointers body_pointers(const Batch& batch, const LaneBits& lanes, btRigidBody& placeholder) {
  BodyPointers pointers;
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    pointers[lane] = lanes[lane] ? batch.bodies[lane] : &placeholder;
  return pointers;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
