#include "bullet/locked_axes.h"

#include <Eigen/LU>

#include "bullet/conversions.h"
#include "polhode/rotation_math.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

Vector3 locked_change_W(const Matrix3& inverse_inertia_W, const Vector3& angular_factor,
                        const Vector3& free_change_W) {
  // Locked rows: (I_W^-1 torque)_i = -change_i; free rows: torque_i = 0.
  Matrix3 system = Matrix3::Identity();
  Vector3 right = Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (angular_factor[axis] != 0.0) continue;
    system.row(axis) = inverse_inertia_W.row(axis);
    right[axis] = -free_change_W[axis];
  }
  const Vector3 locking_torque_impulse = system.partialPivLu().solve(right);
  return angular_factor.cwiseProduct(free_change_W + inverse_inertia_W * locking_torque_impulse);
}

void hold_locked_axes(const btRigidBody& body, const StepInput& input, const RotationState& start,
                      RotationState& end) {
  const Vector3 solved_W = start.omega_W + input.delta_omega_W;
  const Vector3 change_W = locked_change_W(inverse_inertia_W(start.R_WB, input.inertia_B),
                                           to_double(body.getAngularFactor()), end.omega_W - solved_W);
  const Vector3 omega_W = solved_W + change_W;
  set_orientation(end, (exponential(omega_W * input.turn_dt) * start.q_WB).normalized());
  set_omega(end, input.inertia_B, omega_W);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
