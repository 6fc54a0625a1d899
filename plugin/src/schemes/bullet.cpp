// bullet: reproduces Bullet's default behaviour, as the control.
//
//   delta_omega = q_t delta_omega_b by the Newton step of `implicit_gyroscopic`, at omega_t
//   omega_{t+1} = omega_t + (change by the solver) + delta_omega
//   q_{t+1} = d q_t,  d the exponential map of omega_{t+1} dt, limited at pi/4
//
// Mirrors the formulas of Bullet 3.24, in double precision. Source: Bullet 3.24,
// btRigidBody::computeGyroscopicImpulseImplicit_Body and
// btTransformUtil::integrateTransform (exponential map after F. S. Grassia, J. Graphics Tools 3 (1998) 29).
// Order: 1. Conserves: neither energy nor L (both decay); det R exactly.
// Fails when: |omega| dt > pi/4: the body then turns by 2 atan((|omega|/omega_c) tan(pi/8)) with
// omega_c = pi/(4 dt), which is less than the velocity it reports.
#include "scheme_base/scheme_definition.h"

namespace polhode::schemes {

namespace {

using namespace formulas;

template <class Real>
void turn(const Vector<Real>& omega_W, const Real& dt, StateOf<Real>& state) {
  set_orientation(state, turn_like_bullet(state.q_WB, omega_W, dt));
}

template <class Real>
void step(const StepInputOf<Real>& input, StateOf<Real>& state) {
  const Vector<Real> omega_B = state.R_WB.transpose() * state.omega_W;
  const Vector<Real> gyroscopic_change_B = implicit_gyroscopic_change_B(input.inertia_B, omega_B, input.dt);
  const Vector<Real> omega_W = state.omega_W + input.delta_omega_W + state.R_WB * gyroscopic_change_B;
  turn<Real>(omega_W, input.dt, state);
  set_omega(state, input.inertia_B, omega_W);
}

}  // namespace

const RotationScheme& bullet() {
  static const WideSchemeDefinition<step<Wide>, turn<Wide>> scheme(
      {"bullet", "Bullet's default update reproduced, the control",
       "Bullet 3.24, btRigidBody.cpp, btTransformUtil.h",
       "|omega| dt > pi/4: turns less than the velocity it reports", 1, Conservation::lost,
       Conservation::lost, Conservation::exact, TurnVelocity::end});
  return scheme;
}

}  // namespace polhode::schemes
