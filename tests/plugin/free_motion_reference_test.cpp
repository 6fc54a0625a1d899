// Tests the reference's own error, which must be far below the errors measured against it.
#include "support/free_motion_reference.h"

#include <gtest/gtest.h>

namespace polhode::testing {
namespace {

TEST(FreeMotionReference, ConvergesWithOrderFourAndIsAtRoundingWhenUsed) {
  const Vector3 inertia_B(1.0, 2.0, 3.0);
  const RotationState start = state_from(inertia_B, Quaternion::Identity(), {3.0, 2.0, 4.0});
  const auto at = [&](int steps) { return integrate_finely(inertia_B, start, 0.5, steps).q_WB; };
  const double ratio = angle_between(at(50), at(20000)) / angle_between(at(100), at(20000));
  // measured 15.8
  EXPECT_NEAR(ratio, 16.0, 0.5);
  // measured 1.1e-14
  EXPECT_LE(angle_between(at(10000), at(20000)), 5e-14);
}

}  // namespace
}  // namespace polhode::testing
