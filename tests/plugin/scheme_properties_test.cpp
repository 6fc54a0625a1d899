// Checks every registered scheme against the properties that it declares; new schemes are included
// automatically.
#include <gtest/gtest.h>

#include <cmath>

#include "polhode/scheme_registry.h"
#include "support/free_motion_reference.h"

namespace polhode {
namespace {

using testing::angle_between;
using testing::integrate_finely;
using testing::state_from;

class EveryScheme : public ::testing::TestWithParam<SchemePointer> {
 protected:
  const RotationScheme& scheme() { return *GetParam(); }

  RotationState run(RotationState state, double duration, int steps) {
    const double dt = duration / steps;
    for (int i = 0; i < steps; ++i) scheme().step({inertia_B_, Vector3::Zero(), dt}, state);
    return state;
  }

  // The largest relative errors of energy and L_W over a run.
  struct Drift {
    double energy = 0.0;
    double L_W = 0.0;
    double rotation = 0.0;
  };

  Drift drift(double duration, int steps) {
    RotationState state = start_;
    const double dt = duration / steps;
    Drift worst;
    for (int i = 0; i < steps; ++i) {
      scheme().step({inertia_B_, Vector3::Zero(), dt}, state);
      worst.energy = std::max(worst.energy, std::abs(state.energy() / start_.energy() - 1.0));
      worst.L_W = std::max(worst.L_W, (state.L_W - start_.L_W).norm() / start_.L_W.norm());
      worst.rotation = std::max(worst.rotation, std::abs(state.R_WB.determinant() - 1.0));
    }
    return worst;
  }

  const Vector3 inertia_B_{1.0, 2.0, 3.0};
  const RotationState start_ =
      state_from(inertia_B_, Quaternion(0.5, 0.1, -0.7, 0.5).normalized(), {3.0, 2.0, 4.0});
};

// Halving the step divides the error by 2^order.
TEST_P(EveryScheme, ConvergesWithTheOrderItDeclares) {
  const double duration = 0.5;
  const RotationState exact = integrate_finely(inertia_B_, start_, duration, 20000);
  const auto error = [&](int steps) {
    const RotationState end = run(start_, duration, steps);
    return angle_between(end.q_WB, exact.q_WB) + (end.omega_W - exact.omega_W).norm();
  };
  const std::optional<int> order = scheme().description().order;
  if (!order) {
    // measured 5.5e-13, almost all of it from the reference
    EXPECT_LE(error(50), 2e-12);
    return;
  }
  // Small enough for the leading term of the error to dominate, large enough for rounding not to matter.
  const int steps = *order == 1 ? 4000 : *order == 2 ? 1000 : 200;
  const double slope = std::log2(error(steps) / error(2 * steps));
  EXPECT_NEAR(slope, *order,
              *order < 4 ? 0.002 : 0.02);  // measured 0.9999 to 1.0002, 2.00000, 3.995 to 3.997
}

TEST_P(EveryScheme, KeepsWhatItDeclaresExactAndLosesWhatItDeclaresLost) {
  const SchemeDescription declared = scheme().description();
  // Schemes of order 4 lose measurably only in large steps: these take about 13 degrees per step, the others
  // 1.3.
  const bool high_order = declared.order.value_or(1) >= 4;
  const int steps = high_order ? 48 : 480;
  const Drift after_2_s = drift(2.0, steps);
  const Drift after_4_s = drift(4.0, 2 * steps);
  const auto check = [high_order](Conservation conservation, double error,
                                  double error_after_twice_the_time) {
    switch (conservation) {
      case Conservation::exact:
        // measured 0 for L, 2.0e-15 for det R, 3.8e-15 for energy
        EXPECT_LE(error_after_twice_the_time, 2e-14);
        break;
      case Conservation::bounded:
        EXPECT_LE(error_after_twice_the_time, 1.2 * error);
        EXPECT_LE(error, 0.1);
        break;
      case Conservation::lost:
        // measured 0.0176 to 0.29; 3.4e-5 with order 4
        EXPECT_GT(error, high_order ? 1e-5 : 0.01);
        EXPECT_GT(error_after_twice_the_time, 1.01 * error);
        break;
    }
  };
  {
    SCOPED_TRACE("energy");
    check(declared.energy, after_2_s.energy, after_4_s.energy);
  }
  {
    SCOPED_TRACE("angular momentum");
    check(declared.angular_momentum, after_2_s.L_W, after_4_s.L_W);
  }
  {
    SCOPED_TRACE("rotation");
    check(declared.rotation, after_2_s.rotation, after_4_s.rotation);
  }
}

TEST_P(EveryScheme, LeavesAStateWhoseMembersAgree) {
  RotationState state = start_;
  for (int i = 0; i < 100; ++i) scheme().step({inertia_B_, Vector3(0.01, 0.0, -0.02), 0.01}, state);
  const Matrix3 inverse_inertia_W =
      state.R_WB * inertia_B_.cwiseInverse().asDiagonal() * state.R_WB.transpose();
  // measured 7.6e-16
  EXPECT_LE((inverse_inertia_W * state.L_W - state.omega_W).norm(), 4e-15 * state.omega_W.norm());
  EXPECT_NEAR(state.q_WB.norm(), 1.0, 1e-15);
  if (scheme().description().rotation == Conservation::exact) {
    EXPECT_EQ(state.q_WB.toRotationMatrix(), state.R_WB);
  }
}

TEST_P(EveryScheme, DependsOnItsArgumentsAlone) {
  EXPECT_EQ(run(start_, 1.0, 60).q_WB.coeffs(), run(start_, 1.0, 60).q_WB.coeffs());
  RotationState at_rest;
  scheme().step({inertia_B_, Vector3::Zero(), 0.01}, at_rest);
  EXPECT_EQ(at_rest.q_WB.coeffs(), Quaternion::Identity().coeffs());
  EXPECT_EQ(at_rest.omega_W, Vector3::Zero());
}

// A kick changes the velocity with which the step turns the body.
TEST_P(EveryScheme, TakesAKickInTheStepThatBringsIt) {
  RotationState state;
  const double dt = 0.01;
  scheme().step({Vector3(2.0, 2.0, 2.0), Vector3(0.0, 0.5, 0.0), dt}, state);
  // measured 0
  EXPECT_NEAR(state.omega_W.y(), 0.5, 1e-15);
  // An Euler step turns by 2 atan(x/2), a matrix by atan(x): measured 1.0e-8 and 4.2e-8 less than x.
  EXPECT_NEAR(angle_between(state.q_WB, Quaternion::Identity()), 0.5 * dt, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryScheme, ::testing::ValuesIn(built_in_schemes()),
                         [](const auto& scheme) { return std::string(scheme.param->description().name); });

}  // namespace
}  // namespace polhode
