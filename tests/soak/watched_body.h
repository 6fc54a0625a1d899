#pragma once

#include <cmath>

#include "polhode/bullet/rotation_control.h"
#include "soak/soak_run.h"

namespace polhode::testing {

/// A free body that the application never changes, with its initial energy and angular momentum.
class WatchedBody {
 public:
  explicit WatchedBody(const BodyRotation& start) : energy_(start.energy_J), L_W_(start.state.L_W) {}

  void add_drift(const BodyRotation& now, Drift& drift) const {
    const double energy = std::abs(now.energy_J / energy_ - 1);
    const double momentum = (now.state.L_W - L_W_).norm() / L_W_.norm();
    // std::max would lose a NaN.
    drift.energy = energy <= drift.energy ? drift.energy : energy;
    drift.angular_momentum = momentum <= drift.angular_momentum ? drift.angular_momentum : momentum;
  }

 private:
  double energy_;
  Vector3 L_W_;
};

}  // namespace polhode::testing
