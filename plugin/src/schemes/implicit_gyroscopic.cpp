// implicit_gyroscopic: the gyroscopic torque by implicit Euler, one Newton step in the body frame; it loses
// energy.
//
//   omega_{t+1} = omega_t + dt I_t^-1 tau_t + delta_omega_{t+1}                     (eq. 6)
//   omega_b0 = q_t^-1 omega_t,  f = dt omega_b0 x I_B omega_b0                      (eq. 7)
//   J delta_omega_b = -f,  J = I_B + dt ([omega_b0] I_B - [I_B omega_b0])           (eq. 8, 9)
//   delta_omega_{t+1} = q_t delta_omega_b                                           (eq. 10)
//   q_{t+1} by eq. 3
//
// The torque's part, dt I_t^-1 tau_t, reaches the scheme in delta_omega_W with whatever else the solver did.
//
// Source: ETH Zurich, Physically-Based Simulation 2018, exercise 2, problem 4; the same Newton step as
// btRigidBody::computeGyroscopicImpulseImplicit_Body, after E. Catto, "Numerical Methods", GDC 2015.
// Order: 1. Conserves: neither energy nor L (both decay); det R exactly.
// Fails when: |omega| dt is not small: a tumble dies within seconds. It does not blow up, but from some 1.4
// rad a step on the one Newton step may miss by far and energy leap up, a hundred-thousandfold if moments
// differ much.
#include "lanes/instruction_sets.h"
#include "schemes/scheme_definition.h"

namespace polhode::schemes {

namespace {

POLHODE_FOR_EACH_INSTRUCTION_SET
void step(const LaneInput& input, LaneState& state) noexcept {
  const Vector3L omega_W =
      state.omega_W + input.delta_omega_W +
      formulas::implicit_gyroscopic_change_W(state.R_WB, input.inertia_B, state.omega_W, input.dt);
  set_orientation(state, formulas::turn_by_euler(state.q_WB, omega_W, input.turn_dt));
  set_omega(state, input.inertia_B, omega_W);
}

}  // namespace

const RotationScheme& implicit_gyroscopic() {
  static const LaneSchemeDefinition scheme(
      {"implicit_gyroscopic", "gyroscopic torque by one Newton step of implicit Euler, which loses energy",
       "handout eq. 6-10, problem 4",
       "|omega| dt is not small: a tumble dies within seconds; past 1.4 energy may leap up", 1,
       Conservation::lost, Conservation::lost, Conservation::exact},
      step);
  return scheme;
}

}  // namespace polhode::schemes
