// quaternion: like `matrix`, with a unit quaternion instead of the matrix.
//
//   omega_{t+1} = I_t^-1 (l_{t+1} - q_t h),  I_t^-1 = R(q_t) I_B^-1 R(q_t)^T
//   q* = q_t + (dt/2) [0, omega_{t+1}] q_t,   q_{t+1} = q*/|q*|   (eq. 3)
//
// h is the momentum of rotors inside the body, which the exercise does not have.
//
// Source: ETH Zurich, Physically-Based Simulation 2018, exercise 2, problem 2.
// Order: 1. Conserves: L_W exactly; energy not (it drifts towards an extreme that |L| allows); det R exactly.
// Fails when: |omega| dt is not small: a step turns by 2 atan(|omega| dt / 2), always less than half a turn.
// On joints the scheme gains energy without bound: a chain of five bodies explodes at 0.08 rad a step.
//
// The velocity after the step is I_{t+1}^-1 (l - q_{t+1} h), for the reason given in `matrix`.
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
  // (1)  l' = tau, whose impulse dt tau is I_t delta_omega
  const Vector<Real> L_W = state.L_W + times_inertia_W(state.R_WB, input.inertia_B, input.delta_omega_W);
  // steps 1, 2 of problem 1:  omega_{t+1} = I_t^-1 l_{t+1},  I_t^-1 = R_t I_b^-1 R_t^T
  const Vector<Real> omega_W =
      times_inverse_inertia_W(state.R_WB, input.inertia_B, without_rotor(state, L_W));
  turn<Real>(omega_W, input.dt, state);
  set_angular_momentum(state, input.inertia_B, L_W);
}

}  // namespace

const RotationScheme& quaternion() {
  static const WideSchemeDefinition<step<Wide>, turn<Wide>> scheme(
      {"quaternion", "Euler step of a unit quaternion at constant momentum", "handout eq. 3, problem 2",
       "|omega| dt is not small: turns by 2 atan(|omega| dt / 2); on joints energy grows without bound", 1,
       Conservation::lost, Conservation::exact, Conservation::exact, TurnVelocity::start, true});
  return scheme;
}

}  // namespace polhode::schemes
