#pragma once

#include <cmath>
#include <random>

#include "polhode/rotation_state.h"

namespace polhode::testing {

/// Random bodies: moments of inertia of real bodies and others (violating the triangle inequality), spins of
/// 0.01 to 100 rad/s, uniformly distributed orientations. Seeded, so that failures are reproducible.
class RandomBody {
 public:
  explicit RandomBody(unsigned start_seed) : generator_(start_seed) {}

  Vector3 inertia_B() { return {log_uniform(1e-2, 1e2), log_uniform(1e-2, 1e2), log_uniform(1e-2, 1e2)}; }

  Vector3 omega_W() { return log_uniform(1e-2, 1e2) * Vector3(normal(), normal(), normal()).normalized(); }

  Quaternion q_WB() { return Quaternion(normal(), normal(), normal(), normal()).normalized(); }

 private:
  double log_uniform(double low, double high) {
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(generator_));
  }
  double normal() { return std::normal_distribution<double>()(generator_); }

  std::mt19937 generator_;
};

}  // namespace polhode::testing
