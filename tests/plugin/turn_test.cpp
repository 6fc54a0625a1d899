// Tests a scheme's turn at constant velocity, and its step in terms of that turn.
#include <gtest/gtest.h>

#include <string>

#include "polhode/rotation_math.h"
#include "polhode/scheme_registry.h"
#include "support/free_motion_reference.h"
#include "support/random_body.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::angle_between;
using testing::RandomBody;
using testing::same_bits;
using testing::state_from;

constexpr double kDt = 1.0 / 60.0;

class Turn : public ::testing::TestWithParam<SchemePointer> {
 protected:
  const RotationScheme& scheme() { return *GetParam(); }
  TurnVelocity turn_velocity() { return scheme().description().turn_velocity; }
};

TEST_P(Turn, ChangesTheOrientationOnly) {
  RandomBody random(41);
  for (int i = 0; i < 100; ++i) {
    const RotationState start = state_from(random.inertia_B(), random.q_WB(), random.omega_W());
    RotationState state = start;
    scheme().turn(random.omega_W(), kDt, state);
    EXPECT_TRUE(same_bits(state.omega_W, start.omega_W));
    EXPECT_TRUE(same_bits(state.L_W, start.L_W));
    EXPECT_FALSE(same_bits(state.q_WB.coeffs(), start.q_WB.coeffs()));
    if (scheme().description().rotation == Conservation::exact) {
      EXPECT_TRUE(same_bits(state.R_WB.reshaped(), state.q_WB.toRotationMatrix().reshaped()));
    }
  }
}

// For small turns every scheme agrees with the exponential, and the reverse turn returns to the start.
TEST_P(Turn, IsByOmegaDt) {
  RandomBody random(42);
  for (int i = 0; i < 100; ++i) {
    const RotationState start = state_from(random.inertia_B(), random.q_WB(), Vector3::Zero());
    const Vector3 omega_W = 1e-3 / kDt * random.omega_W().normalized();
    RotationState state = start;
    scheme().turn(omega_W, kDt, state);
    // measured 3.3e-10 with matrix, 8.3e-11 with an Euler step, 3.2e-16 otherwise
    EXPECT_LE(angle_between(state.q_WB, exponential(kDt * omega_W) * start.q_WB), 5e-10);
    scheme().turn(omega_W, -kDt, state);
    EXPECT_LE(angle_between(state.q_WB, start.q_WB), 2e-15);  // measured 6.0e-16
  }
}

TEST_P(Turn, AtNoVelocityKeepsTheOrientation) {
  RandomBody random(43);
  for (int i = 0; i < 20; ++i) {
    const RotationState start = state_from(random.inertia_B(), random.q_WB(), random.omega_W());
    RotationState state = start;
    scheme().turn(Vector3::Zero(), kDt, state);
    // measured 3.4e-16, from normalising a unit quaternion again
    EXPECT_LE((state.q_WB.coeffs() - start.q_WB.coeffs()).norm(), 1e-15);
    if (turn_velocity() == TurnVelocity::mean) {
      EXPECT_TRUE(same_bits(state, start));
    }
  }
}

TEST_P(Turn, MakesTheStepAtTheVelocityThatItDeclares) {
  RandomBody random(44);
  double farthest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Vector3 inertia_B(1.0, 2.0, 3.0 - 0.001 * i);
    const Vector3 kick_W = random.omega_W().normalized();
    const RotationState start = state_from(inertia_B, random.q_WB(), 20.0 * random.omega_W().normalized());
    RotationState stepped = start;
    scheme().step({inertia_B, kick_W, kDt}, stepped);
    RotationState turned = start;
    const bool at_end = turn_velocity() == TurnVelocity::end;
    scheme().turn(at_end ? stepped.omega_W : Vector3(start.omega_W + kick_W), kDt, turned);
    if (at_end) {
      EXPECT_TRUE(same_bits(turned.q_WB.coeffs(), stepped.q_WB.coeffs()));
    }
    farthest = std::max(farthest, angle_between(turned.q_WB, stepped.q_WB));
  }
  if (turn_velocity() == TurnVelocity::mean) {
    EXPECT_GT(farthest, 1e-3);  // measured 0.029 to 0.032: the velocity changes within the step
  } else {
    EXPECT_LE(farthest, 4e-15);  // measured 1.3e-15 with matrix
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, Turn, ::testing::ValuesIn(built_in_schemes()),
                         [](const auto& scheme) { return std::string(scheme.param->description().name); });

}  // namespace
}  // namespace polhode
