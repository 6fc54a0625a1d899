#include "free_motion.h"

#include <algorithm>
#include <cmath>

FreeMotion::FreeMotion(const Eigen::Vector3d& inertia_B, const Eigen::Matrix3d& R_WB,
                       const Eigen::Vector3d& omega_W)
    : inertia_B_(inertia_B.cast<long double>()) {
  state_.q_WB = Quaternion(R_WB.cast<long double>()).normalized();
  state_.omega_B = state_.q_WB.conjugate() * omega_W.cast<long double>().eval();
}

// Euler's equations, and dq/dt = 1/2 q [0, omega_B].
FreeMotion::State FreeMotion::rate(const State& state) const {
  const Vector& omega = state.omega_B;
  const Vector L = inertia_B_.cwiseProduct(omega);
  Quaternion turn = state.q_WB * Quaternion(0.0L, omega.x(), omega.y(), omega.z());
  turn.coeffs() *= 0.5L;
  return {turn, L.cross(omega).cwiseQuotient(inertia_B_)};
}

void FreeMotion::advance(double duration_s) {
  constexpr long double kStepAngle = 1e-3L;
  const long double angle = state_.omega_B.norm() * static_cast<long double>(duration_s);
  const int steps = std::max(1, static_cast<int>(std::ceil(angle / kStepAngle)));
  const long double h = static_cast<long double>(duration_s) / steps;
  const auto moved = [](const State& state, const State& rate, long double by) {
    State result = state;
    result.q_WB.coeffs() += by * rate.q_WB.coeffs();
    result.omega_B += by * rate.omega_B;
    return result;
  };
  for (int step = 0; step < steps; ++step) {
    const State k1 = rate(state_);
    const State k2 = rate(moved(state_, k1, h / 2));
    const State k3 = rate(moved(state_, k2, h / 2));
    const State k4 = rate(moved(state_, k3, h));
    for (const auto& [k, weight] : {std::pair{k1, 1.0L}, {k2, 2.0L}, {k3, 2.0L}, {k4, 1.0L}}) {
      state_ = moved(state_, k, weight * h / 6);
    }
    state_.q_WB.normalize();
  }
}

double FreeMotion::angle_to(const Eigen::Matrix3d& R_WB) const {
  const Quaternion other = Quaternion(R_WB.cast<long double>()).normalized();
  const Quaternion difference = state_.q_WB.conjugate() * other;
  return static_cast<double>(2 * std::atan2(difference.vec().norm(), std::abs(difference.w())));
}
