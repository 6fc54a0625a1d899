#include "support/free_motion_reference.h"

#include <cmath>

namespace polhode::testing {

namespace {

using Coefficients = Eigen::Vector4d;  // x, y, z, w

Vector3 omega_of(const Vector3& inertia_B, const Coefficients& q, const Vector3& L_W) {
  const Matrix3 R_WB = Eigen::Quaterniond(q).normalized().toRotationMatrix();
  return R_WB * (R_WB.transpose() * L_W).cwiseQuotient(inertia_B);
}

Coefficients rate_of(const Vector3& inertia_B, const Coefficients& q, const Vector3& L_W) {
  const Vector3 omega_W = omega_of(inertia_B, q, L_W);
  const Eigen::Quaterniond omega(0.0, omega_W.x(), omega_W.y(), omega_W.z());
  return 0.5 * (omega * Eigen::Quaterniond(q)).coeffs();
}

}  // namespace

RotationState integrate_finely(const Vector3& inertia_B, RotationState state, double duration, int steps,
                               const Vector3& torque_W) {
  const double h = duration / steps;
  const Vector3 L_start_W = state.L_W;
  Coefficients q = state.q_WB.coeffs();
  for (int step = 0; step < steps; ++step) {
    const auto L_W = [&](double stage) { return Vector3(L_start_W + (step + stage) * h * torque_W); };
    const Coefficients k1 = rate_of(inertia_B, q, L_W(0.0));
    const Coefficients k2 = rate_of(inertia_B, q + 0.5 * h * k1, L_W(0.5));
    const Coefficients k3 = rate_of(inertia_B, q + 0.5 * h * k2, L_W(0.5));
    const Coefficients k4 = rate_of(inertia_B, q + h * k3, L_W(1.0));
    q += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    q.normalize();
  }
  state.q_WB.coeffs() = q;
  state.R_WB = state.q_WB.toRotationMatrix();
  state.L_W = L_start_W + duration * torque_W;
  state.omega_W = omega_of(inertia_B, q, state.L_W);
  return state;
}

double angle_between(const Quaternion& a, const Quaternion& b) {
  const Eigen::Quaterniond difference = Eigen::Quaterniond(a).conjugate() * Eigen::Quaterniond(b);
  return 2.0 * std::atan2(difference.vec().norm(), std::abs(difference.w()));
}

RotationState state_from(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& omega_W) {
  const Matrix3 R_WB = q_WB.toRotationMatrix();
  return {q_WB, R_WB, omega_W, R_WB * inertia_B.cwiseProduct(R_WB.transpose() * omega_W)};
}

}  // namespace polhode::testing
