// matrix: the rotation matrix itself is integrated, and swells.
//
//   I_t^-1 = R_t I_B^-1 R_t^T            (problem 1, step 1)
//   omega_{t+1} = I_t^-1 l_{t+1}         (step 2, Omega by eq. 2)
//   R_{t+1} = R_t + dt Omega_{t+1} R_t   (step 3)
//
// and q_{t+1} is the rotation nearest to R_{t+1} (nearest_rotation.h).
//
// Source: ETH Zurich, Physically-Based Simulation 2018, exercise 2, problem 1.
// Order: 1. Conserves: L_W exactly; energy not; det R not: each step multiplies it by 1 + |omega|^2 dt^2.
// Fails when: always, in the end. R leaves SO(3) from the first step on, and once R R^T is far from the
// identity rounding tips omega off L and the motion blows up.
//
// The velocity left behind is I_{t+1}^-1 l, the one the next step turns with, so that omega and L agree
// between steps. A kick counts by the velocity it makes, so that a contact that stops the body stops it;
// since I_t shrinks as R swells, the momentum that a torque brings shrinks with it.
#include "lanes/instruction_sets.h"
#include "schemes/nearest_rotation.h"
#include "schemes/scheme_definition.h"

namespace polhode::schemes {

namespace {

POLHODE_FOR_EACH_INSTRUCTION_SET
void step(const LaneInput& input, LaneState& state) noexcept {
  const Vector3L L_W =
      state.L_W + formulas::angular_momentum_W(state.R_WB, input.inertia_B, input.delta_omega_W);
  const Vector3L omega_W = formulas::inverse_inertia_W(state.R_WB, input.inertia_B) * L_W;
  const Vector3L turn_W = input.turn_dt * omega_W;
  for (int i = 0; i < 3; ++i) state.R_WB.col(i) += turn_W.cross(state.R_WB.col(i));
  state.q_WB = nearest_rotation(state.R_WB, state.q_WB);
  set_angular_momentum(state, input.inertia_B, L_W);
}

}  // namespace

const RotationScheme& matrix() {
  static const LaneSchemeDefinition scheme(
      {"matrix", "Euler step of the rotation matrix, which swells", "handout eq. 1-2, problem 1",
       "always in the end: det R grows by 1 + |omega|^2 dt^2 a step", 1, Conservation::lost,
       Conservation::exact, Conservation::lost},
      step);
  return scheme;
}

}  // namespace polhode::schemes
