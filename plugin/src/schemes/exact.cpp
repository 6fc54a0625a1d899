// exact: free motion in closed form, without error except rounding.
//
//   L_W <- L_W + I_W(q_t) delta_omega_W             kick
//   L_B(t + h) by the addition theorem of Jacobi's elliptic functions
//   q_{t+1} = q_t (e0, e),  e0 e_i = mu_i (L_B(t) + L_B(t + h))_i,  mu_i computed once for a motion
//   omega_{t+1} = I_W(q_{t+1})^-1 L_W
//
// The constants are kept in the body's memory while the body moves freely with the same dt. A body with
// rotors is a gyrostat, whose motion is computed by its Taylor series up to rounding. Derivation and sources:
// free_top/.
//
// Order: free motion has no error. Torques: order 1. Contacts and joints: order 1, like the solver.
// Conserves: energy, L_W, det R exactly.
// Fails when: |omega| dt times rounding is not small: beyond 1e9 rad a step the angle is known only to 1e-7.
// For a body with rotors: beyond about 4,000 rad a step.
#include "free_top/free_top_step.h"
#include "free_top/gyrostat_step.h"
#include "free_top/momentum_match.h"
#include "free_top/wide_steps.h"
#include "scheme_base/kick_and_turn.h"
#include "scheme_base/scheme_definition.h"

namespace polhode::schemes {

namespace {

using free_top::FreeTopStep;

void turn_freely(const StepInput& input, const Vector3& L_W, RotationState& state,
                 FreeTopStep<double>& kept) {
  const Vector3 L_B = state.R_WB.transpose() * L_W;
  if (L_B.norm() < free_top::kAtRest) return;
  Quaternion q_WB = state.q_WB;
  if (free_top::fits(kept, L_B, input.dt)) {
    q_WB = q_WB * free_top::alignment(free_top::angular_momentum_B(kept), L_B);
  } else {
    kept = free_top::make_free_top_step(input.inertia_B, L_B, input.dt);
  }
  set_orientation(state, free_top::advance(kept, q_WB, L_W).normalized());
}

// Takes a step of any length.
void step_one(std::size_t lane, const WideStepInput& wide_input, WideState& wide_state, Wide* memory) {
  StepInput input;
  RotationState state;
  FreeTopStep<double> kept{};
  get_lane(lane, wide_input, input);
  get_lane(lane, wide_state, state);
  if (memory != nullptr) free_top::get_lane(lane, memory, kept);
  const Vector3 L_W = kicked_L_W<double>(input, state);
  turn_freely(input, L_W, state, kept);
  set_angular_momentum(state, input.inertia_B, L_W);
  set_lane(lane, state, wide_state);
  if (memory != nullptr) free_top::set_lane(lane, kept, memory);
}

void step_gyrostat(std::size_t lane, const WideStepInput& wide_input, WideState& wide_state, Wide* memory) {
  StepInput input;
  RotationState state;
  get_lane(lane, wide_input, input);
  get_lane(lane, wide_state, state);
  const Vector3 L_W = kicked_L_W<double>(input, state);
  if (memory == nullptr) {
    free_top::turn_gyrostat(input, L_W, state, nullptr);
  } else {
    free_top::KeptEnergy kept = free_top::get_kept_energy(lane, memory);
    free_top::turn_gyrostat(input, L_W, state, &kept);
    free_top::set_kept_energy(lane, kept, memory);
  }
  set_angular_momentum(state, input.inertia_B, L_W);
  set_lane(lane, state, wide_state);
}

std::bitset<kLanes> has_rotor(const Vector3Wide& rotor_B) {
  std::bitset<kLanes> result;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    for (int i = 0; i < 3; ++i) result[lane] = result[lane] || rotor_B[i][lane] != 0.0;
  }
  return result;
}

class Exact final : public WideScheme {
 public:
  SchemeDescription description() const noexcept override {
    return {"exact",
            "free motion in closed form, without error but rounding",
            "Landau & Lifshitz, Mechanics, section 37; DLMF 22.8",
            "never in free motion; contacts and joints are as good as the solver",
            std::nullopt,
            Conservation::exact,
            Conservation::exact,
            Conservation::exact,
            TurnVelocity::mean,
            true};
  }

  std::size_t memory_rows() const noexcept override { return FreeTopStep<double>::kNumbers; }

  void step_wide(const WideStepInput& input, const WideMask& mask, WideState& state,
                 WideMemoryRow* memory) const noexcept override {
    if (state.rotor_momentum_B) {
      step_with_rotors(input, mask, state, memory);
    } else {
      step_without_rotors(input, mask, state, memory);
    }
  }

 private:
  static void step_without_rotors(const WideStepInput& input, const WideMask& mask, WideState& state,
                                  WideMemoryRow* memory) {
    const std::bitset<kLanes> left = free_top::take_short_steps(input, mask, state, memory);
    for (std::size_t lane = 0; lane < kLanes && left.any(); ++lane) {
      if (left[lane]) step_one(lane, input, state, memory);
    }
  }

  static void step_with_rotors(const WideStepInput& input, const WideMask& mask, WideState& state,
                               WideMemoryRow* memory) {
    const std::bitset<kLanes> gyrostats = mask.bits() & has_rotor(*state.rotor_momentum_B);
    WideState others = state;
    others.rotor_momentum_B.reset();
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (gyrostats[lane]) step_gyrostat(lane, input, state, memory);
    }
    const WideMask plain = mask & !WideMask::from_bits(gyrostats);
    step_without_rotors(input, plain, others, memory);
    others.rotor_momentum_B = state.rotor_momentum_B;
    state = select(plain, others, state);
  }
};

}  // namespace

const RotationScheme& exact() {
  static const Exact scheme;
  return scheme;
}

}  // namespace polhode::schemes
