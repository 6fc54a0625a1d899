#include "oracle/heavy_top.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace polhode::oracle {
namespace {

constexpr HeavyTop kTop = {0.005, 0.008, 1.0, 0.05, 9.81};

// In steady precession the angular momentum about the fixed point turns with the axis: Omega e_z x L is the
// torque.
TEST(HeavyTop, TurnsItsMomentumByTheTorqueOfGravity) {
  for (const double tilt : {0.1, 0.5, 1.5, std::acos(0.0), 3.0}) {
    for (const double spin : {20.0, 150.0, -20.0}) {
      const SteadyTop top = steadily_precessing(kTop, tilt, spin);
      const Vector3 along = top.omega_W.dot(top.axis_W) * top.axis_W;
      const double about_point = kTop.transverse + kTop.mass * kTop.length * kTop.length;
      const Vector3 L_W = kTop.axial * along + about_point * (top.omega_W - along);
      const Vector3 torque_W = (kTop.length * top.axis_W).cross(Vector3(0, 0, -kTop.mass * kTop.gravity));
      const Vector3 change_W = slow_precession(kTop, tilt, spin) * Vector3::UnitZ().cross(L_W);
      EXPECT_LT((change_W - torque_W).norm(), 1e-15) << tilt << " " << spin;         // measured 2.2e-16
      EXPECT_NEAR(top.omega_W.dot(top.axis_W), spin, 1e-13) << tilt << " " << spin;  // measured 2.8e-14
    }
  }
}

TEST(HeavyTop, PrecessesAsGyroscopesDoWhenItSpinsFast) {
  const double fast = 1e6;
  EXPECT_NEAR(slow_precession(kTop, 0.5, fast) * kTop.axial * fast, 9.81 * 0.05, 1e-10);  // measured 2.5e-11
}

TEST(HeavyTop, CannotStandWhenItSpinsTooSlowly) {
  EXPECT_THROW(slow_precession(kTop, 0.5, 1.0), std::invalid_argument);
  EXPECT_THROW(slow_precession(kTop, 2.0, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace polhode::oracle
