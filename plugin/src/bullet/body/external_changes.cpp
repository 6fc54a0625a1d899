#include "bullet/body/external_changes.h"

#include <algorithm>
#include <cmath>

#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

void make_momentum_agree(const Vector3& inertia_B, bool keeps_rotation, RotationState& state) {
  if (keeps_rotation) {
    set_omega(state, inertia_B, state.omega_W);
  } else {
    state.L_W = with_rotor(state, angular_momentum_W(state.R_WB, inertia_B, state.omega_W));
  }
}

Vector3 moments_B(const btVector3& inverse_inertia_B) {
  return to_double(inverse_inertia_B).unaryExpr([](double inverse) {
    return inverse == 0.0 ? 0.0 : 1.0 / inverse;
  });
}

bool adopt_external_changes(const Batch& batch, std::size_t lane, RotationState& state) {
  const btRigidBody& body = *batch.bodies[lane];
  const btMatrix3x3& basis = body.getWorldTransform().getBasis();
  const btVector3& omega_W = body.getAngularVelocity();
  const btVector3 written_omega_W = vector_in_lane(batch.written_omega_W, lane);
  const bool turned = !same(basis, to_bullet(Matrix3(state.q_WB.toRotationMatrix())));
  const bool kicked = !same(omega_W, written_omega_W);
  const bool reshaped = !same(body.getInvInertiaDiagLocal(), vector_in_lane(batch.inverse_inertia_B, lane));
  if (!turned && !kicked && !reshaped) return false;
  if (turned) set_orientation(state, to_quaternion(basis));
  state.omega_W = velocity_after_kick(to_double(omega_W), to_double(written_omega_W), state.omega_W);
  make_momentum_agree(moments_B(body.getInvInertiaDiagLocal()), batch.keeps_rotation, state);
  return true;
}

void adopt_external_changes(Batch& batch, std::size_t lane) {
  RotationState state = batch.state(lane);
  if (!adopt_external_changes(batch, lane, state)) return;
  batch.set_state(lane, state);
  const btRigidBody& body = *batch.bodies[lane];
  set_vector_in_lane(lane, body.getAngularVelocity(), batch.written_omega_W);
  set_vector_in_lane(lane, body.getInvInertiaDiagLocal(), batch.inverse_inertia_B);
}

void adopt_external_rotation(const Quaternion& turn_B, const Vector3& inertia_B, bool keeps_rotation,
                             RotationState& state) {
  const Matrix3 R_WB = state.R_WB * turn_B.toRotationMatrix();
  set_orientation(state, (state.q_WB * turn_B).normalized());
  if (!keeps_rotation) state.R_WB = R_WB;
  make_momentum_agree(inertia_B, keeps_rotation, state);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
