// semi_implicit_gyroscopic: the gyroscopic torque at the start of the step; gains energy and blows up.
//
//   omega_{t+1} = omega_t + dt I_t^-1 (tau_t - omega_t x I_t omega_t)   (eq. 4, 5)
//   q_{t+1} by eq. 3
//
// delta_omega = dt I_t^-1 tau_t, the change by the torque, is the kick of the step. With rotors inside the
// body, I_t omega_t stands for the total angular momentum.
//
// Source: ETH Zurich, Physically-Based Simulation 2018, exercise 2, problem 3.
// Order: 1. Conserves: neither energy nor L; det R exactly.
// Fails when: it runs long enough. The torque is quadratic in omega, so the gain of energy accelerates.
#include "scheme_base/scheme_definition.h"

namespace polhode::schemes {

namespace {

using namespace formulas;

template <class Real>
void turn(const Vector<Real>& omega_W, const Real& dt, StateOf<Real>& state) {
  // (3)  q_{t+1} = q*/|q*|,  q* = q_t + dt/2 [0, omega] q_t
  set_orientation(state, turn_by_euler(state.q_WB, omega_W, dt));
}

template <class Real>
void step(const StepInputOf<Real>& input, StateOf<Real>& state) {
  // (4)  tau_g = omega_t x I_t omega_t.  L_W is I_t omega_t, including the rotors' momentum.
  const Vector<Real> tau_g_W = state.omega_W.cross(state.L_W);
  // (5)  omega_{t+1} = omega_t + dt I_t^-1 (tau_t - tau_g)
  const Vector<Real> omega_W = state.omega_W + input.delta_omega_W -
                               input.dt * times_inverse_inertia_W(state.R_WB, input.inertia_B, tau_g_W);
  turn<Real>(omega_W, input.dt, state);
  set_omega(state, input.inertia_B, omega_W);
}

}  // namespace

const RotationScheme& semi_implicit_gyroscopic() {
  static const WideSchemeDefinition<step<Wide>, turn<Wide>> scheme(
      {"semi_implicit_gyroscopic", "gyroscopic torque by semi-implicit Euler, which gains energy",
       "handout eq. 4-5, problem 3", "it runs long: energy grows without bound until it overflows", 1,
       Conservation::lost, Conservation::lost, Conservation::exact, TurnVelocity::end, true});
  return scheme;
}

}  // namespace polhode::schemes
