// quaternion: as `matrix`, with a unit quaternion for the matrix.
//
//   omega_{t+1} = I_t^-1 l_{t+1},  I_t^-1 = R(q_t) I_B^-1 R(q_t)^T
//   q* = q_t + (dt/2) [0, omega_{t+1}] q_t,   q_{t+1} = q*/|q*|   (eq. 3)
//
// Source: ETH Zurich, Physically-Based Simulation 2018, exercise 2, problem 2.
// Order: 1. Conserves: L_W exactly; energy not (it drifts towards an extreme that |L| allows); det R exactly.
// Fails when: |omega| dt is not small: a step turns by 2 atan(|omega| dt / 2), never more than half a turn.
//
// The velocity left behind is I_{t+1}^-1 l, as in `matrix`.
#include "lanes/instruction_sets.h"
#include "schemes/scheme_definition.h"

namespace polhode::schemes {

namespace {

POLHODE_FOR_EACH_INSTRUCTION_SET
void step(const LaneInput& input, LaneState& state) noexcept {
  const Vector3L L_W =
      state.L_W + formulas::times_inertia_W(state.R_WB, input.inertia_B, input.delta_omega_W);
  const Vector3L omega_W = formulas::times_inverse_inertia_W(state.R_WB, input.inertia_B, L_W);
  set_orientation(state, formulas::turn_by_euler(state.q_WB, omega_W, input.turn_dt));
  set_angular_momentum(state, input.inertia_B, L_W);
}

}  // namespace

const RotationScheme& quaternion() {
  static const LaneSchemeDefinition scheme(
      {"quaternion", "Euler step of a unit quaternion at constant momentum", "handout eq. 3, problem 2",
       "|omega| dt is not small: a step turns by 2 atan(|omega| dt / 2)", 1, Conservation::lost,
       Conservation::exact, Conservation::exact},
      step);
  return scheme;
}

}  // namespace polhode::schemes
