// implicit_gyroscopic: the gyroscopic torque by implicit Euler, one Newton step in the body frame; loses
// energy.
//
//   omega_{t+1} = omega_t + dt I_t^-1 tau_t + delta_omega_{t+1}                     (eq. 6)
//   omega_b0 = q_t^-1 omega_t,  f = dt omega_b0 x I_B omega_b0                      (eq. 7)
//   J delta_omega_b = -f,  J = I_B + dt ([omega_b0] I_B - [I_B omega_b0])           (eq. 8, 9)
//   delta_omega_{t+1} = q_t delta_omega_b                                           (eq. 10)
//   q_{t+1} by eq. 3
//
// delta_omega = dt I_t^-1 tau_t, the change by the torque, is the kick of the step. For rotors of momentum h
// inside the body, f gains dt omega_b0 x h, and I_B omega_b0 in J becomes I_B omega_b0 + h.
//
// Source: ETH Zurich, Physically-Based Simulation 2018, exercise 2, problem 4; the same Newton step as
// btRigidBody::computeGyroscopicImpulseImplicit_Body, after E. Catto, "Numerical Methods", GDC 2015.
// Order: 1. Conserves: neither energy nor L (both decay); det R exactly.
// Fails when: |omega| dt is not small: a tumble dies out within seconds. The scheme does not blow up, but
// beyond about 1.4 rad a step the single Newton step may be far off, and energy may leap up, by a factor of a
// hundred thousand if the moments differ much.
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
  const Real& dt = input.dt;
  const Matrix<Real> I_b = input.inertia_B.asDiagonal();
  // (8)  omega_b^0 = q^-1 omega_t
  const Vector<Real> omega_b = state.R_WB.transpose() * state.omega_W;
  // (7)  f = dt omega_b x I_b omega_b
  Vector<Real> f = dt * omega_cross_I_omega(input.inertia_B, omega_b);
  // (9)  J = I_b + dt (Omega(omega_b) I_b - Omega(I_b omega_b))
  Matrix<Real> J = I_b + dt * (skew(omega_b) * I_b - skew<Real>(I_b * omega_b));
  if (state.rotor_momentum_B) {
    const Vector<Real>& h = *state.rotor_momentum_B;
    f += dt * omega_b.cross(h);
    J -= dt * skew(h);
  }
  // (8)  J delta_omega_b = -f
  const Vector<Real> delta_omega_b = -solve(J, f);
  // (10), (6)  omega_{t+1} = omega_t + delta_omega + q delta_omega_b
  const Vector<Real> omega_W = state.omega_W + input.delta_omega_W + state.R_WB * delta_omega_b;
  turn<Real>(omega_W, dt, state);
  set_omega(state, input.inertia_B, omega_W);
}

}  // namespace

const RotationScheme& implicit_gyroscopic() {
  static const WideSchemeDefinition<step<Wide>, turn<Wide>> scheme(
      {"implicit_gyroscopic", "gyroscopic torque by one Newton step of implicit Euler, which loses energy",
       "handout eq. 6-10, problem 4",
       "|omega| dt is not small: a tumble dies within seconds; past 1.4 energy may leap up", 1,
       Conservation::lost, Conservation::lost, Conservation::exact, TurnVelocity::end, true});
  return scheme;
}

}  // namespace polhode::schemes
