// exact: free motion in closed form, without error but rounding.
//
//   L_W <- L_W + I_W(q_t) delta_omega_W             kick, if something acted
//   L_B(t + h) by the addition theorem of Jacobi's elliptic functions
//   q_{t+1} = q_t (e0, e),  e0 e_i = mu_i (L_B(t) + L_B(t + h))_i,  mu_i found once for a motion
//   omega_{t+1} = I_W(q_{t+1})^-1 L_W
//
// The constants are kept in the body's memory while it moves freely at the same dt. Derivation and sources:
// free_top/.
//
// Order: free motion has no error. Torques that act alone, constant over a step in the world or in the body:
// order 2. Contacts, joints: as the solver, order 1. Conserves: energy, L_W, det R exactly.
// Fails when: |omega| dt times rounding is no longer small: past 1e9 rad a step the angle is known to 1e-7.
#include "free_top/lane_steps.h"
#include "free_top/momentum_match.h"
#include "schemes/kick_drift.h"
#include "schemes/scheme_definition.h"

namespace polhode::schemes {

namespace {

using free_top::FreeTopStep;

void drift(const StepInput& input, const Vector3& L_W, RotationState& state, FreeTopStep& step) {
  const Vector3 L_B = state.R_WB.transpose() * L_W;
  if (L_B.norm() < free_top::kAtRest) return;
  Quaternion q_WB = state.q_WB;
  if (free_top::fits(step, input.inertia_B, L_B, input.turn_dt)) {
    q_WB = q_WB * free_top::alignment(free_top::angular_momentum_B(step), L_B);
  } else {
    step = free_top::make_free_top_step(input.inertia_B, L_B, input.turn_dt);
  }
  set_orientation(state, free_top::advance(step, q_WB, L_W).normalized());
}

// A step of any kind.
void step_alone(const StepInput& input, RotationState& state, SchemeMemory& memory) {
  auto& step = memory.get<FreeTopStep>();
  kick_and_drift(input, state, [&](const Vector3& L_W) { drift(input, L_W, state, step); });
}

void step_lane_alone(std::size_t lane, const LaneInput& input, LaneState& state, SchemeMemory& memory) {
  StepInput input_alone;
  RotationState state_alone;
  get_lane(lane, input, input_alone);
  get_lane(lane, state, state_alone);
  step_alone(input_alone, state_alone, memory);
  set_lane(lane, state_alone, state);
}

class Exact final : public LaneScheme {
 public:
  SchemeDescription description() const noexcept override {
    return {"exact",
            "free motion in closed form, without error but rounding",
            "Landau & Lifshitz, Mechanics, section 37; DLMF 22.8",
            "never in free motion; contacts and joints are as good as the solver",
            std::nullopt,
            Conservation::exact,
            Conservation::exact,
            Conservation::exact};
  }

  void step_lanes(const LaneInput& input, LaneState& state,
                  const LaneMemories& memories) const noexcept override {
    std::array<FreeTopStep*, kLanes> steps;
    for (std::size_t lane = 0; lane < kLanes; ++lane) steps[lane] = &memories.of[lane]->get<FreeTopStep>();
    free_top::LanesLeft left;
    free_top::take_steps(input, steps, state, left);
    if (left.none()) return;
    for (std::size_t lane = 0; lane < memories.count; ++lane) {
      if (left[lane]) step_lane_alone(lane, input, state, *memories.of[lane]);
    }
  }

  // Bodies on which something acts are put together, for they cost more. What step a body takes is its own
  // affair, never that of the company it is in.
  void step_bodies(const BodyStep* bodies, std::size_t count) const noexcept override {
    Group free;
    Group changed;
    for (std::size_t i = 0; i < count; ++i) {
      const BodyStep& body = bodies[i];
      if (!body.input->torque_W.isZero(0.0)) {
        step_alone(*body.input, *body.state, *body.memory);
      } else if (body.input->delta_omega_W.isZero(0.0)) {
        add(body, free);
      } else {
        add(body, changed);
      }
    }
    finish(free);
    finish(changed);
  }

 private:
  struct Group {
    std::array<BodyStep, kLanes> bodies;
    std::size_t count = 0;
  };

  void add(const BodyStep& body, Group& group) const {
    group.bodies[group.count] = body;
    ++group.count;
    if (group.count == kLanes) finish(group);
  }

  void finish(Group& group) const {
    LaneScheme::step_bodies(group.bodies.data(), group.count);
    group.count = 0;
  }
};

}  // namespace

const RotationScheme& exact() {
  static const Exact scheme;
  return scheme;
}

}  // namespace polhode::schemes
