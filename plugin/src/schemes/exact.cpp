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
using free_top::LaneBodies;

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
void step_alone(const BodyStep& body, FreeTopStep& step) {
  kick_and_drift(*body.input, *body.state,
                 [&](const Vector3& L_W) { drift(*body.input, L_W, *body.state, step); });
}

// Puts bodies together that take the same kind of step. Which kind a body takes is its own affair, never that
// of the company it is in.
class Groups {
 public:
  void add(const BodyStep& body) {
    const StepInput& input = *body.input;
    auto& step = body.memory->get<FreeTopStep>();
    const bool has_torque = !input.torque_W.isZero(0.0);
    const bool is_changed =
        !input.delta_omega_W.isZero(0.0) || !is_made_for(step, input.inertia_B, input.turn_dt);
    if (is_changed && !has_torque) {
      add_to_changed(body, step);
    } else if (has_torque || !step.is_short()) {
      step_alone(body, step);
    } else {
      free_.add(body, step);
      if (free_.is_full()) step_free();
    }
  }

  void finish() {
    if (!free_.is_empty()) step_free();
    if (!changed_.is_empty()) step_changed();
  }

 private:
  void add_to_changed(const BodyStep& body, FreeTopStep& step) {
    changed_.add(body, step);
    if (changed_.is_full()) step_changed();
  }

  void step_free() {
    free_.fill_up();
    const free_top::LanesLeft left = free_top::take_steps(free_);
    for (std::size_t lane = 0; lane < kLanes && left.any(); ++lane) {
      if (left[lane]) add_to_changed(free_.body(lane), free_.step(lane));
    }
    free_.clear();
  }

  void step_changed() {
    changed_.fill_up();
    const free_top::LanesLeft left = free_top::make_and_take_steps(changed_);
    for (std::size_t lane = 0; lane < kLanes && left.any(); ++lane) {
      if (left[lane]) step_alone(changed_.body(lane), changed_.step(lane));
    }
    changed_.clear();
  }

  LaneBodies free_;     // with a FreeTopStep that fits, but perhaps for L
  LaneBodies changed_;  // in need of another FreeTopStep
};

class Exact final : public RotationScheme {
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

  void step(const StepInput& input, RotationState& state) const noexcept override {
    SchemeMemory memory;
    step_with_memory(input, state, memory);
  }

  void step_with_memory(const StepInput& input, RotationState& state,
                        SchemeMemory& memory) const noexcept override {
    const BodyStep body = {&input, &state, &memory};
    step_bodies(&body, 1);
  }

  void step_bodies(const BodyStep* bodies, std::size_t count) const noexcept override {
    Groups groups;
    for (std::size_t i = 0; i < count; ++i) groups.add(bodies[i]);
    groups.finish();
  }
};

}  // namespace

const RotationScheme& exact() {
  static const Exact scheme;
  return scheme;
}

}  // namespace polhode::schemes
