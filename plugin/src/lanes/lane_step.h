#pragma once

#include "lanes/lane_block.h"
#include "rotation_formulas.h"

/// StepInput and RotationState of eight bodies, and what rotation_math.h has for the latter.
namespace polhode {

struct LaneInput {
  Vector3L inertia_B;
  Vector3L delta_omega_W;
  Lanes dt;
  Lanes turn_dt;

  explicit LaneInput(const LaneBlock& block)
      : inertia_B(block.load([](const BodyStep& body) -> auto& { return body.input->inertia_B; })),
        delta_omega_W(block.load([](const BodyStep& body) -> auto& { return body.input->delta_omega_W; })),
        dt(block.load_scalar([](const BodyStep& body) { return body.input->dt; })),
        turn_dt(block.load_scalar([](const BodyStep& body) { return body.input->turn_dt; })) {}
};

struct LaneState {
  QuaternionL q_WB;
  Matrix3L R_WB;
  Vector3L omega_W;
  Vector3L L_W;

  explicit LaneState(const LaneBlock& block)
      : q_WB(block.load([](const BodyStep& body) -> auto& { return body.state->q_WB.coeffs(); })),
        R_WB(block.load([](const BodyStep& body) -> auto& { return body.state->R_WB; })),
        omega_W(block.load([](const BodyStep& body) -> auto& { return body.state->omega_W; })),
        L_W(block.load([](const BodyStep& body) -> auto& { return body.state->L_W; })) {}

  void store(const LaneBlock& block) const {
    block.store(
        q_WB.coeffs(), [](const BodyStep& body) -> auto& { return body.state->q_WB.coeffs(); });
    block.store(
        R_WB, [](const BodyStep& body) -> auto& { return body.state->R_WB; });
    block.store(
        omega_W, [](const BodyStep& body) -> auto& { return body.state->omega_W; });
    block.store(
        L_W, [](const BodyStep& body) -> auto& { return body.state->L_W; });
  }
};

inline void set_orientation(LaneState& state, const QuaternionL& q_WB) {
  state.q_WB = q_WB;
  state.R_WB = q_WB.toRotationMatrix();
}

inline void set_omega(LaneState& state, const Vector3L& inertia_B, const Vector3L& omega_W) {
  state.omega_W = omega_W;
  state.L_W = formulas::times_inertia_W(state.R_WB, inertia_B, omega_W);
}

inline void set_angular_momentum(LaneState& state, const Vector3L& inertia_B, const Vector3L& L_W) {
  state.L_W = L_W;
  state.omega_W = formulas::times_inverse_inertia_W(state.R_WB, inertia_B, L_W);
}

/// `step(input, state)` for all the bodies, eight at a time.
template <class Step>
void step_in_lanes(const BodyStep* bodies, std::size_t count, Step step) {
  in_blocks(bodies, count, [step](const LaneBlock& block) {
    const LaneInput input(block);
    LaneState state(block);
    step(input, state);
    state.store(block);
  });
}

}  // namespace polhode
