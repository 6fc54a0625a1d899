// matrix: integrates the rotation matrix itself, which swells.
//
//   S_b = (b, R, p, l), S_b' = (v, Omega, f, tau)              (eq. 1)
//   I_t^-1 = R_t I_B^-1 R_t^T                                  (problem 1, step 1)
//   omega_{t+1} = I_t^-1 l_{t+1}, Omega_{t+1} = [omega_{t+1}]  (step 2, eq. 2)
//   R_{t+1} = R_t + dt Omega_{t+1} R_t                         (step 3)
//
// and q_{t+1} is the rotation nearest to R_{t+1} (math/polar.h).
//
// Source: ETH Zurich, Physically-Based Simulation 2018, exercise 2, problem 1.
// Order: 1. Conserves: L_W exactly; energy not; det R not: each step multiplies it by 1 + |omega|^2 dt^2.
// Fails when: always, in the end. R leaves SO(3) from the first step on. Once R R^T is far from the identity,
// rounding tips omega away from L, and the motion blows up. On joints the scheme gains energy without bound:
// a chain of five bodies explodes at 0.08 rad a step.
//
// The velocity after the step is I_{t+1}^-1 l, which is the velocity that the next step turns by, so that
// omega and L agree between steps. A kick adds I_t delta_omega to l, so that a contact that stops the body
// does stop it. Since I_t shrinks as R swells, the momentum by a torque shrinks as well.
#include "math/polar.h"
#include "scheme_base/scheme_definition.h"

namespace polhode::schemes {

namespace {

using namespace formulas;

template <class Real>
void turn(const Vector<Real>& omega_W, const Real& dt, StateOf<Real>& state) {
  // (2)  Omega = [omega]
  const Matrix<Real> Omega = skew(omega_W);
  // step 3:  R_{t+1} = R_t + dt Omega R_t
  const Matrix<Real> rate = Omega * state.R_WB;
  state.R_WB += dt * rate;
  state.q_WB = nearest_rotation(state.R_WB, state.q_WB);
}

template <class Real>
void step(const StepInputOf<Real>& input, StateOf<Real>& state) {
  // (1)  l' = tau, whose impulse dt tau is I_t delta_omega
  const Vector<Real> L_W = state.L_W + angular_momentum_W(state.R_WB, input.inertia_B, input.delta_omega_W);
  // step 1:  I_t^-1 = R_t I_b^-1 R_t^T
  const Matrix<Real> I_t_inverse = inverse_inertia_W(state.R_WB, input.inertia_B);
  // step 2:  omega_{t+1} = I_t^-1 l_{t+1}
  const Vector<Real> omega_W = I_t_inverse * L_W;
  turn<Real>(omega_W, input.dt, state);
  set_angular_momentum(state, input.inertia_B, L_W);
}

}  // namespace

const RotationScheme& matrix() {
  static const WideSchemeDefinition<step<Wide>, turn<Wide>> scheme(
      {"matrix", "Euler step of the rotation matrix, which swells", "handout eq. 1-2, problem 1",
       "always in the end: det R grows by 1 + |omega|^2 dt^2 a step; on joints energy grows without bound", 1,
       Conservation::lost, Conservation::exact, Conservation::lost, TurnVelocity::start});
  return scheme;
}

}  // namespace polhode::schemes
