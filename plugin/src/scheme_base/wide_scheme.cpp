#include "scheme_base/wide_scheme.h"

#include "simd/instruction_sets.h"

namespace polhode {

namespace {

template <class Doubles, class Values>
void set_all_lanes(const Doubles& doubles, Values& result) {
  for (int i = 0; i < Values::SizeAtCompileTime; ++i) result.coeffRef(i) = doubles.coeff(i);
}

// Fills all lanes, although only the first one counts, so that no lane is slow or traps.
void set_all_lanes(const RotationState& state, WideState& result) {
  set_all_lanes(state.q_WB.coeffs(), result.q_WB.coeffs());
  set_all_lanes(state.R_WB, result.R_WB);
  set_all_lanes(state.omega_W, result.omega_W);
  set_all_lanes(state.L_W, result.L_W);
  result.rotor_momentum_B.reset();
  if (!state.has_rotor()) return;
  result.rotor_momentum_B.emplace();
  set_all_lanes(state.rotor_momentum_B, *result.rotor_momentum_B);
}

POLHODE_FOR_EACH_INSTRUCTION_SET
void turn_eight_exponentially(const Vector3Wide& omega_W, const Wide& dt, WideState& state) noexcept {
  set_orientation(state, formulas::turn_exponentially(state.q_WB, omega_W, dt));
}

}  // namespace

void WideScheme::step(const StepInput& input, RotationState& state) const noexcept {
  WideStepInput wide_input;
  WideState wide_state;
  set_all_lanes(input.inertia_B, wide_input.inertia_B);
  set_all_lanes(input.delta_omega_W, wide_input.delta_omega_W);
  wide_input.dt = input.dt;
  set_all_lanes(state, wide_state);
  step_wide(wide_input, WideMask::from_bits(1), wide_state, nullptr);
  get_lane(0, wide_state, state);
}

void WideScheme::turn(const Vector3& omega_W, double dt, RotationState& state) const noexcept {
  Vector3Wide wide_omega_W;
  WideState wide_state;
  set_all_lanes(omega_W, wide_omega_W);
  set_all_lanes(state, wide_state);
  turn_wide(wide_omega_W, dt, wide_state);
  get_lane(0, wide_state, state);
}

void WideScheme::turn_wide(const Vector3Wide& omega_W, const Wide& dt, WideState& state) const noexcept {
  turn_eight_exponentially(omega_W, dt, state);
}

}  // namespace polhode
