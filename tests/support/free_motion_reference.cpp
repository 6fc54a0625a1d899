#include "support/free_motion_reference.h"

#include <cmath>

namespace polhode::testing {

namespace {

using Coefficients = Eigen::Vector4d;  // x, y, z, w

struct Motion {
  Coefficients q_WB;
  Vector3 L_W;

  Motion operator+(const Motion& other) const { return {q_WB + other.q_WB, L_W + other.L_W}; }
  Motion operator*(double factor) const { return {factor * q_WB, factor * L_W}; }
};

Matrix3 matrix_of(const Motion& motion) {
  return Eigen::Quaterniond(motion.q_WB).normalized().toRotationMatrix();
}

Vector3 omega_of(const Vector3& inertia_B, const Motion& motion) {
  const Matrix3 R_WB = matrix_of(motion);
  return R_WB * (R_WB.transpose() * motion.L_W).cwiseQuotient(inertia_B);
}

Coefficients turn_rate_of(const Vector3& inertia_B, const Motion& motion) {
  const Vector3 omega_W = omega_of(inertia_B, motion);
  const Eigen::Quaterniond omega(0.0, omega_W.x(), omega_W.y(), omega_W.z());
  return 0.5 * (omega * Eigen::Quaterniond(motion.q_WB)).coeffs();
}

}  // namespace

RotationState integrate_finely(const Vector3& inertia_B, const RotationState& start, double duration,
                               int steps, const Vector3& torque_W, bool turns_with_body) {
  const double h = duration / steps;
  const Vector3 torque_B = start.q_WB.toRotationMatrix().transpose() * torque_W;
  const auto rate = [&](const Motion& motion) {
    const Vector3 torque_now_W = turns_with_body ? Vector3(matrix_of(motion) * torque_B) : torque_W;
    return Motion{turn_rate_of(inertia_B, motion), torque_now_W};
  };
  Motion motion{start.q_WB.coeffs(), start.L_W};
  for (int step = 0; step < steps; ++step) {
    const Motion k1 = rate(motion);
    const Motion k2 = rate(motion + k1 * (0.5 * h));
    const Motion k3 = rate(motion + k2 * (0.5 * h));
    const Motion k4 = rate(motion + k3 * h);
    motion = motion + (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (h / 6.0);
    motion.q_WB.normalize();
  }
  RotationState end;
  end.q_WB.coeffs() = motion.q_WB;
  end.R_WB = end.q_WB.toRotationMatrix();
  end.L_W = motion.L_W;
  end.omega_W = omega_of(inertia_B, motion);
  return end;
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
