// bullet: what Bullet does by default, reproduced, as the control.
//
//   delta_omega = q_t delta_omega_b by the Newton step of `implicit_gyroscopic`, at the start-of-step
//   velocity omega_{t+1} = omega_t + (what the solver changed) + delta_omega q_{t+1} = d q_t,  d the
//   exponential map of omega_{t+1} dt, cut at pi/4
//
// Source: Bullet 3.24, btRigidBody::computeGyroscopicImpulseImplicit_Body and
// btTransformUtil::integrateTransform (exponential map after F. S. Grassia, J. Graphics Tools 3 (1998) 29).
// Order: 1. Conserves: neither energy nor L (both decay); det R exactly.
// Fails when: |omega| dt > pi/4: it then turns by 2 atan((|omega|/omega_c) tan(pi/8)), omega_c = pi/(4 dt),
// less than the velocity it reports.
//
// In free flight it follows Bullet to rounding. Where a body touches or is joined to another it follows
// closely, not to rounding: Bullet hands delta_omega to the solver before it solves, the adapter adds every
// scheme's after.
#include "lanes/instruction_sets.h"
#include "schemes/scheme_definition.h"

namespace polhode::schemes {

namespace {

POLHODE_FOR_EACH_INSTRUCTION_SET
void step(const LaneInput& input, LaneState& state) noexcept {
  const Vector3L omega_W =
      state.omega_W + input.delta_omega_W +
      formulas::implicit_gyroscopic_change_W(state.R_WB, input.inertia_B, state.omega_W, input.dt);
  set_orientation(state, formulas::turn_like_bullet(state.q_WB, omega_W, input.turn_dt));
  set_omega(state, input.inertia_B, omega_W);
}

}  // namespace

const RotationScheme& bullet() {
  static const LaneSchemeDefinition scheme({"bullet", "Bullet's default update reproduced, the control",
                                            "Bullet 3.24, btRigidBody.cpp, btTransformUtil.h",
                                            "|omega| dt > pi/4: turns less than the velocity it reports", 1,
                                            Conservation::lost, Conservation::lost, Conservation::exact},
                                           step);
  return scheme;
}

}  // namespace polhode::schemes
