#pragma once

#include "polhode/torque_law.h"

namespace polhode::testing {

/// Where and when a driven motion begins. The body moves in a straight line.
struct DrivenStart {
  double time_s = 0.0;
  Vector3 position_W = Vector3::Zero();
  Vector3 velocity_W = Vector3::Zero();
};

/// Integrates rotation under a torque law by the classical Runge-Kutta method in small steps:
///   dL_W/dt = tau_W + R tau_B,  dh/dt = tau_rotor,  dq_WB/dt = 1/2 [0, omega_W] q_WB,
///   omega_W = R I_B^-1 (R^T L_W - h).
/// An oracle for the orders of schemes: its error is far below theirs (tested by halving its step).
RotationState integrate_driven(const Vector3& inertia_B, const RotationState& start, const DrivenStart& place,
                               const TorqueLaw& law, double duration, int steps);

}  // namespace polhode::testing
