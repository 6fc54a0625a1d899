// semi_implicit_gyroscopic: the gyroscopic torque taken at the start of the step; it gains energy and blows
// up.
//
//   omega_{t+1} = omega_t + dt I_t^-1 (tau_t - omega_t x I_t omega_t)   (eq. 4, 5)
//   q_{t+1} by eq. 3
//
// The torque's part, dt I_t^-1 tau_t, reaches the scheme in delta_omega_W with whatever else the solver did.
//
// Source: ETH Zurich, Physically-Based Simulation 2018, exercise 2, problem 3.
// Order: 1. Conserves: neither energy nor L; det R exactly.
// Fails when: it runs long enough. The torque is quadratic in omega, so the energy it gains feeds its own
// growth.
#include "lanes/instruction_sets.h"
#include "schemes/scheme_definition.h"

namespace polhode::schemes {

namespace {

POLHODE_FOR_EACH_INSTRUCTION_SET
void step(const LaneInput& input, LaneState& state) noexcept {
  // L_W = I_t omega_t; the same product, whose value at the start of the step the state carries.
  const Vector3L gyroscopic_torque_W = state.omega_W.cross(state.L_W);
  const Vector3L gyroscopic_change_W =
      -input.dt * formulas::times_inverse_inertia_W(state.R_WB, input.inertia_B, gyroscopic_torque_W);
  const Vector3L omega_W = state.omega_W + input.delta_omega_W + gyroscopic_change_W;
  set_orientation(state, formulas::turn_by_euler(state.q_WB, omega_W, input.turn_dt));
  set_omega(state, input.inertia_B, omega_W);
}

}  // namespace

const RotationScheme& semi_implicit_gyroscopic() {
  static const LaneSchemeDefinition scheme(
      {"semi_implicit_gyroscopic", "gyroscopic torque by semi-implicit Euler, which gains energy",
       "handout eq. 4-5, problem 3", "it runs long: energy grows without bound until it overflows", 1,
       Conservation::lost, Conservation::lost, Conservation::exact},
      step);
  return scheme;
}

}  // namespace polhode::schemes
