#pragma once

#include "polhode/rotation_state.h"

namespace polhode::testing {

/// Free or torqued rotation by the classical Runge-Kutta method in small steps, of the equations
///   dL_W/dt = tau_W,  dq_WB/dt = 1/2 [0, omega_W] q_WB,  omega_W = R_WB I_B^-1 R_WB^T L_W.
/// An oracle for the orders of the schemes: its own error is far below theirs (tested by halving its step).
/// The torque is constant in the world, or `turns_with_body`: `torque_W` at the start, constant in the body.
RotationState integrate_finely(const Vector3& inertia_B, const RotationState& start, double duration,
                               int steps, const Vector3& torque_W = Vector3::Zero(),
                               bool turns_with_body = false);

/// The angle of the rotation between two orientations, rad.
double angle_between(const Quaternion& a, const Quaternion& b);

/// A state at rest in L: orientation and angular velocity given, L_W to agree.
RotationState state_from(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& omega_W);

}  // namespace polhode::testing
