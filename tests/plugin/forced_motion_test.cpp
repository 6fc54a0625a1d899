// Torques that act alone, constant in the world or in the body, are of order 2 in every scheme that is so in
// free motion, or better.
#include <gtest/gtest.h>

#include <cmath>

#include "polhode/rotation_math.h"
#include "polhode/scheme_registry.h"
#include "support/free_motion_reference.h"

namespace polhode {
namespace {

using testing::angle_between;
using testing::integrate_finely;
using testing::state_from;

struct Forcing {
  const char* name;
  Vector3 inertia_B;
  Vector3 omega_B;
  Vector3 torque_B;  ///< at the start
  bool turns_with_body;
};

void PrintTo(const Forcing& forcing, std::ostream* stream) {
  *stream << forcing.name;
}

std::vector<SchemePointer> schemes_of_order_2() {
  std::vector<SchemePointer> found;
  for (const SchemePointer& scheme : built_in_schemes()) {
    if (scheme->description().order.value_or(2) >= 2) found.push_back(scheme);
  }
  return found;
}

class ForcedMotion : public ::testing::TestWithParam<std::tuple<SchemePointer, Forcing>> {
 protected:
  const RotationScheme& scheme() { return *std::get<0>(GetParam()); }
  const Forcing& forcing() { return std::get<1>(GetParam()); }

  RotationState start() {
    const Quaternion q_WB = Quaternion(0.5, 0.1, -0.7, 0.5).normalized();
    return state_from(forcing().inertia_B, q_WB, q_WB * forcing().omega_B);
  }

  RotationState after_one_second(int steps) {
    const double dt = 1.0 / steps;
    RotationState state = start();
    const Vector3 torque_start_W = state.R_WB * forcing().torque_B;
    for (int i = 0; i < steps; ++i) {
      const Vector3 torque_W =
          forcing().turns_with_body ? Vector3(state.R_WB * forcing().torque_B) : torque_start_W;
      const Vector3 delta_omega_W = dt * (inverse_inertia_W(state.R_WB, forcing().inertia_B) * torque_W);
      scheme().step({forcing().inertia_B, delta_omega_W, dt, dt, torque_W, forcing().turns_with_body}, state);
    }
    return state;
  }
};

// The error is divided by 4 when the step is halved.
TEST_P(ForcedMotion, IsOfOrderTwo) {
  const Vector3 torque_W = start().R_WB * forcing().torque_B;
  const RotationState reference =
      integrate_finely(forcing().inertia_B, start(), 1.0, 10000, torque_W, forcing().turns_with_body);
  const auto error = [&](const RotationState& end) {
    return angle_between(end.q_WB, reference.q_WB) + (end.L_W - reference.L_W).norm() / reference.L_W.norm();
  };
  const double coarse = error(after_one_second(250));
  const double fine = error(after_one_second(500));
  EXPECT_LE(fine, 1e-3);                            // measured 1.1e-6 to 3.6e-4
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);  // measured 1.998 to 2.0005
}

const Forcing kForcings[] = {
    {"in_the_world", {1, 2, 3}, {3, 2, 4}, {1, -2, 3}, false},
    {"in_the_body", {1, 2, 3}, {3, 2, 4}, {1, -2, 3}, true},
    {"in_the_body_from_rest", {1, 2, 3}, {0, 0, 0}, {3, 4, -5}, true},
    {"in_the_body_of_a_top", {2, 2, 0.5}, {0.5, 0, 8}, {1, 2, 0}, true},
};

INSTANTIATE_TEST_SUITE_P(Registry, ForcedMotion,
                         ::testing::Combine(::testing::ValuesIn(schemes_of_order_2()),
                                            ::testing::ValuesIn(kForcings)),
                         [](const auto& instance) {
                           return std::string(std::get<0>(instance.param)->description().name) + "_" +
                                  std::get<1>(instance.param).name;
                         });

}  // namespace
}  // namespace polhode
