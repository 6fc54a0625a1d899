// The handout's schemes beyond their declared limits.
#include <gtest/gtest.h>

#include <algorithm>

#include "polhode/scheme_registry.h"
#include "support/free_motion_reference.h"

namespace polhode {
namespace {

using testing::state_from;

// Returns the largest E/E0 - 1 over 1000 steps of a spin near the middle axis.
double largest_gain(const Vector3& inertia_B, double omega_dt) {
  const SchemePointer scheme = find_scheme("implicit_gyroscopic");
  const double dt = 1.0 / 60.0;
  const Vector3 omega_W = omega_dt / dt * Vector3(0.01, 1.0, 0.0).normalized();
  const RotationState start = state_from(inertia_B, Quaternion::Identity(), omega_W);
  RotationState state = start;
  double largest = -1.0;
  for (int i = 0; i < 1000; ++i) {
    scheme->step({inertia_B, Vector3::Zero(), dt}, state);
    largest = std::max(largest, state.energy() / start.energy() - 1.0);
  }
  return largest;
}

TEST(ImplicitGyroscopic, LosesEnergyInSmallStepsAndLeapsInLargeOnes) {
  for (const double ratio : {1.1, 2.0, 8.0, 20.0}) {
    const Vector3 inertia_B(1.0, ratio < 2.0 ? 0.5 * (1.0 + ratio) : ratio - 0.5, ratio);
    for (const double omega_dt : {0.1, 0.4}) {
      EXPECT_LT(largest_gain(inertia_B, omega_dt), 0.0) << ratio << " " << omega_dt;
    }
    EXPECT_LE(largest_gain(inertia_B, 1.2), 0.8) << ratio;  // measured up to 0.26
  }
  EXPECT_GT(largest_gain(Vector3(1.0, 7.77, 8.27), 1.6353), 1e4);  // measured 7.4e5
}

}  // namespace
}  // namespace polhode
