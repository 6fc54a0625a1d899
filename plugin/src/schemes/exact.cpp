// exact: free motion in closed form, without error but rounding.
//
//   L_W <- L_W + I_W(q_t) delta_omega_W             kick, if something acted
//   L_B(t + h) by the addition theorem of Jacobi's elliptic functions
//   q_{t+1} = q_t (e0, e),  e0 e_i = mu_i (L_B(t) + L_B(t + h))_i,  mu_i found once for a motion
//   omega_{t+1} = I_W(q_{t+1})^-1 L_W
//
// The constants are kept in the body's memory while it moves freely at the same dt. Derivation and sources:
// free_top/free_top_step.cpp.
//
// Order: free motion has no error. Torques that act alone, constant over a step in the world or in the body:
// order 2. Contacts, joints: as the solver, order 1. Conserves: energy, L_W, det R exactly.
// Fails when: |omega| dt times rounding is no longer small: past 1e9 rad a step the angle is known to 1e-7.
#include "free_top/free_top_step.h"
#include "schemes/kick_drift.h"
#include "schemes/scheme_definition.h"

namespace polhode::schemes {

namespace {

// |L|^2 of a body at rest, (kg m^2/s)^2: its square would underflow.
constexpr double kAtRest = 1e-280;

// Turns q_WB so that it takes L_B to L_W. By rounding alone the two would part, as a random walk.
Quaternion aligned(const Quaternion& q_WB, const Vector3& L_B, const Vector3& found_L_B) {
  // The smallest turn that takes L_B to found_L_B = q_WB^-1 L_W; first order is enough, for it is of 1e-16
  // rad.
  const Vector3 half_turn_B = L_B.cross(found_L_B) / (2.0 * L_B.squaredNorm());
  return q_WB * Quaternion(1.0, half_turn_B.x(), half_turn_B.y(), half_turn_B.z());
}

void drift(const StepInput& input, const Vector3& L_W, RotationState& state, SchemeMemory& memory) {
  const Vector3 L_B = state.R_WB.transpose() * L_W;
  if (L_B.squaredNorm() < kAtRest) return;
  auto& step = memory.get<free_top::FreeTopStep>();
  Quaternion q_WB = state.q_WB;
  if (free_top::fits(step, input.inertia_B, L_B, input.turn_dt)) {
    q_WB = aligned(q_WB, free_top::angular_momentum_B(step), L_B);
  } else {
    step = free_top::make_free_top_step(input.inertia_B, L_B, input.turn_dt);
  }
  set_orientation(state, free_top::advance(step, q_WB, L_W).normalized());
}

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
    kick_and_drift(input, state, [&](const Vector3& L_W) { drift(input, L_W, state, memory); });
  }
};

}  // namespace

const RotationScheme& exact() {
  static const Exact scheme;
  return scheme;
}

}  // namespace polhode::schemes
