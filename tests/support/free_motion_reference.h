#pragma once

#include "polhode/rotation_state.h"

namespace polhode::testing {

/// Integrates free or torqued rotation by the classical Runge-Kutta method in small steps:
///   dL_W/dt = tau_W,  dq_WB/dt = 1/2 [0, omega_W] q_WB,  omega_W = R_WB I_B^-1 R_WB^T L_W.
/// An oracle for the orders of the schemes: its error is far below theirs (tested by halving its step). The
/// torque is constant in the world or, with `turns_with_body`, in the body; `torque_W` is its value at the
/// start.
RotationState integrate_finely(const Vector3& inertia_B, const RotationState& start, double duration,
                               int steps, const Vector3& torque_W = Vector3::Zero(),
                               bool turns_with_body = false);

/// Returns the angle between two orientations, rad.
double angle_between(const Quaternion& a, const Quaternion& b);

/// Returns the state with the given orientation and angular velocity, and L_W computed from them.
RotationState state_from(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& omega_W);

}  // namespace polhode::testing
