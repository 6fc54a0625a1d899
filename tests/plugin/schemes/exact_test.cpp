// Compares `exact` with the closed form in 50 digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/free_top.h"
#include "polhode/scheme_registry.h"
#include "support/free_motion_reference.h"
#include "support/random_body.h"
#include "support/wide_batch.h"

namespace polhode {
namespace {

using oracle::FreeTop;
using testing::RandomBody;
using testing::state_from;

constexpr double kDt = 1.0 / 60.0;
constexpr int kTenSeconds = 600;
const Quaternion kTilted = Quaternion(0.5, 0.1, -0.7, 0.5).normalized();

/// A body stepped by `exact`, and its exact motion.
class FreeRun {
 public:
  FreeRun(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& omega_W, double dt = kDt)
      : inertia_B_(inertia_B),
        start_(state_from(inertia_B, q_WB, omega_W)),
        state_(start_),
        truth_(inertia_B, start_.q_WB, start_.L_W),
        dt_(dt) {}

  void step(int count) {
    for (int i = 0; i < count; ++i) {
      body_.step({inertia_B_, Vector3::Zero(), dt_}, state_);
      ++steps_;
      energy_error_ = std::max(energy_error_, std::abs(state_.energy() / start_.energy() - 1.0));
      momentum_error_ = std::max(momentum_error_, (state_.L_W - start_.L_W).norm() / start_.L_W.norm());
    }
  }

  double attitude_error() const { return truth_.attitude_error_after(state_.q_WB, steps_, dt_); }
  double energy_error() const { return energy_error_; }      // largest so far, relative
  double momentum_error() const { return momentum_error_; }  // of the vector L_W

  /// Returns the present effect on the exact motion of one rounding of the start, rad.
  double conditioning() const {
    const Vector3 rounded_L_W = start_.L_W + 1.1e-16 * start_.L_W.norm() * Vector3(1, -1, 1);
    const FreeTop neighbour(inertia_B_, start_.q_WB, rounded_L_W);
    return truth_.attitude_error_after(neighbour.q_WB(static_cast<double>(steps_) * dt_), steps_, dt_);
  }

 private:
  testing::RememberedBody body_{*find_scheme("exact")};
  Vector3 inertia_B_;
  RotationState start_;
  RotationState state_;
  FreeTop truth_;
  double dt_;
  std::int64_t steps_ = 0;
  double energy_error_ = 0.0;
  double momentum_error_ = 0.0;
};

FreeRun tumble() {
  return {Vector3(1, 2, 3), kTilted, Vector3(3, 2, 4)};
}

FreeRun fast_spinner() {
  return {Vector3(0.4, 0.5, 0.8), kTilted, 200.0 * Vector3(5, 6, 6.2).normalized()};
}

FreeRun flipping() {
  return {Vector3(1, 2, 3), kTilted, Vector3(0.1, 6, 0.1)};
}

TEST(Exact, HasNoErrorButRoundingAfterTenSeconds) {
  for (const auto& start : {tumble, fast_spinner}) {
    FreeRun run = start();
    run.step(kTenSeconds);
    // measured 1.5e-14 and 2.5e-13 rad (after turning by 55 and 2,000 rad); 1.6e-15 and 1.1e-15; 0
    EXPECT_LE(run.attitude_error(), 6e-13);
    EXPECT_LE(run.energy_error(), 3e-15);
    EXPECT_EQ(run.momentum_error(), 0.0);
  }
}

// Moments of 0.01 to 100 kg m^2, most of which no real body has, and spins of up to 100 rad/s.
TEST(Exact, HasNoErrorButRoundingForTwoHundredRandomBodies) {
  RandomBody random(7);
  std::vector<double> errors;
  for (int i = 0; i < 200; ++i) {
    const Vector3 inertia_B = random.inertia_B();
    const Quaternion q_WB = random.q_WB();
    FreeRun run(inertia_B, q_WB, random.omega_W());
    run.step(kTenSeconds);
    errors.push_back(run.attitude_error());
    // measured 3.1e-14; 0
    EXPECT_LE(run.energy_error(), 5e-14);
    EXPECT_EQ(run.momentum_error(), 0.0);
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LE(errors[100], 5e-14);    // measured 7.7e-15 rad
  EXPECT_LE(errors.back(), 1e-11);  // measured 4.4e-12 rad
}

TEST(Exact, ErrorGrowsNoFasterThanLinearlyOverAnHour) {
  for (const auto& start : {tumble, fast_spinner, flipping}) {
    FreeRun run = start();
    run.step(60 * kTenSeconds);
    const double after_ten_minutes = run.attitude_error();
    run.step(300 * kTenSeconds);
    const double after_an_hour = run.attitude_error();
    EXPECT_LE(after_an_hour, 8.0 * after_ten_minutes);  // measured 5.9 to 6.1 times
    EXPECT_LE(after_an_hour, 3e-10);                    // measured 4.7e-12, 8.9e-11, 2.1e-12 rad
  }
}

TEST(Exact, KeepsEnergyAndMomentumForAMillionSteps) {
  FreeRun run = tumble();
  run.step(1000000);
  // measured 1.1e-15; 0
  EXPECT_LE(run.energy_error(), 4e-15);
  EXPECT_EQ(run.momentum_error(), 0.0);
}

TEST(Exact, IsAtRoundingForNearlyEqualMoments) {
  for (double difference = 1e-4; difference > 1e-16; difference *= 0.1) {
    SCOPED_TRACE(difference);
    for (const Vector3& inertia_B : {Vector3(1, 1 + difference, 3), Vector3(1, 3, 3 * (1 + difference)),
                                     Vector3(2, 2 * (1 + difference), 2 * (1 + 2 * difference)),
                                     Vector3(1, 1, 3), Vector3(3, 1, 3), Vector3(2, 2, 2)}) {
      FreeRun run(inertia_B, kTilted, Vector3(3, 2, 4));
      run.step(kTenSeconds);
      // measured 4.3e-14 rad and 2.2e-15
      EXPECT_LE(run.attitude_error(), 2e-13) << inertia_B.transpose();
      EXPECT_LE(run.energy_error(), 1e-14) << inertia_B.transpose();
    }
  }
}

// Near the separatrix the motion itself amplifies rounding: the bound is the effect of one rounding of the
// start on the exact motion.
TEST(Exact, IsAsGoodAsItsStartNearTheSeparatrix) {
  for (double offset = 1e-4; offset > 1e-16; offset *= 0.1) {
    for (const double side : {1.0, -1.0}) {
      SCOPED_TRACE(side * offset);
      // On the separatrix y3^2 (I3 - I2)/I3 = y1^2 (I2 - I1)/I1, for these moments y3^2 = 3 y1^2.
      const Vector3 omega_W(4.0, 2.8, 4.0 * std::sqrt(3.0) * (1.0 + side * offset) / 3.0);
      FreeRun run(Vector3(1, 2, 3), Quaternion::Identity(), omega_W);
      run.step(kTenSeconds);
      // measured up to 2.6 times; 3.3e-14 rad at 1e-4, 2.0e-11 at 1e-6, 1.0e-7 at 1e-10, 1.4e-4 at 1e-14
      EXPECT_LE(run.attitude_error(), 10.0 * run.conditioning());
      EXPECT_LE(run.energy_error(), 1e-14);  // measured 1.3e-15
    }
  }
}

TEST(Exact, KeepsASpinAboutAPrincipalAxisEvenTheMiddleOne) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double speed : {5.0, -5.0, 300.0}) {
      FreeRun run(Vector3(1, 2, 3), Quaternion::Identity(), speed * Vector3::Unit(axis));
      run.step(kTenSeconds);
      // measured 1.3e-13 at 300 rad/s
      EXPECT_LE(run.attitude_error(), 1e-14 * std::abs(speed)) << axis << " " << speed;
    }
  }
}

// A step of any length applies the formulas once. Covers turns of up to 1e8 rad, and every way of splitting
// long steps.
TEST(Exact, TakesAStepOfAnyLength) {
  RandomBody random(11);
  for (int i = 0; i < 2000; ++i) {
    const double angle = std::pow(10.0, -6.0 + 14.0 * i / 2000.0);
    const Vector3 omega_W = random.omega_W();
    FreeRun run(random.inertia_B(), random.q_WB(), omega_W, angle / omega_W.norm());
    run.step(1);
    // measured up to 64 times
    EXPECT_LE(run.attitude_error(), 400.0 * (3e-16 + run.conditioning())) << angle;
    EXPECT_LE(run.energy_error(), 1e-13);
  }
}

// With negative dt, in short and long steps.
TEST(Exact, GoesBackTheWayItCame) {
  for (const double speed : {1.0, 30.0}) {
    const RotationState start = state_from(Vector3(1, 2, 3), kTilted, speed * Vector3(3, 2, 4));
    RotationState state = start;
    testing::RememberedBody body(*find_scheme("exact"));
    for (int i = 0; i < kTenSeconds; ++i) body.step({Vector3(1, 2, 3), Vector3::Zero(), kDt}, state);
    EXPECT_GT(testing::angle_between(state.q_WB, start.q_WB), 0.1);
    for (int i = 0; i < kTenSeconds; ++i) body.step({Vector3(1, 2, 3), Vector3::Zero(), -kDt}, state);
    // measured 4e-15 and 3e-13
    EXPECT_LE(testing::angle_between(state.q_WB, start.q_WB), 2e-14 * speed * speed);
  }
}

TEST(Exact, IsTheSameAtAnySpeed) {
  for (const double speed : {1e-12, 1e-6, 1.0, 1e3, 1e6, 1e9}) {
    for (const double size : {1e-12, 1.0, 1e9}) {
      const double dt = 0.05 / speed;
      FreeRun run(size * Vector3(1, 2, 3), kTilted, speed * Vector3(0.6, 0.4, 0.8), dt);
      run.step(kTenSeconds);
      EXPECT_LE(run.attitude_error(), 1e-13) << speed << " " << size;  // measured 3e-14
    }
  }
}

// The memory is a shortcut: without it every step repeats the set-up, with the same result up to rounding.
TEST(Exact, NeedsNoMemory) {
  const SchemePointer scheme = find_scheme("exact");
  const Vector3 inertia_B(1, 2, 3);
  const RotationState start = state_from(inertia_B, kTilted, Vector3(3, 2, 4));
  const FreeTop truth(inertia_B, start.q_WB, start.L_W);
  RotationState state = start;
  for (int i = 0; i < kTenSeconds; ++i) scheme->step({inertia_B, Vector3::Zero(), kDt}, state);
  EXPECT_LE(truth.attitude_error_after(state.q_WB, kTenSeconds, kDt), 2e-13);
}

// `exact` detects changes between two steps, except changes of the inertia, for which the caller clears the
// memory.
TEST(Exact, NoticesWhatChangedBetweenTwoSteps) {
  testing::RememberedBody body(*find_scheme("exact"));
  Vector3 inertia_B(1, 2, 3);
  RotationState state = state_from(inertia_B, kTilted, Vector3(3, 2, 4));
  double dt = kDt;
  const auto error_of_next_step = [&] {
    const FreeTop truth(inertia_B, state.q_WB, state.L_W);
    body.step({inertia_B, Vector3::Zero(), dt}, state);
    return truth.attitude_error(state.q_WB, dt);
  };
  const auto expect_exact = [&](const char* what) {
    // measured 3e-16 rad
    EXPECT_LE(error_of_next_step(), 2e-15) << what;
    EXPECT_LE(error_of_next_step(), 2e-15) << what;
  };
  expect_exact("start");
  dt = 0.02;
  expect_exact("dt");
  inertia_B = Vector3(1, 2, 2.5);
  body.forget();
  state = state_from(inertia_B, state.q_WB, state.omega_W);
  expect_exact("inertia");
  state = state_from(inertia_B, state.q_WB, state.omega_W + Vector3(1e-9, 0, 0));
  expect_exact("a small kick");
  state = state_from(inertia_B, Quaternion(0.1, 0.9, 0.2, -0.3).normalized(), state.omega_W);
  expect_exact("orientation");
  state = state_from(inertia_B, state.q_WB, Vector3::Zero());
  EXPECT_LE(error_of_next_step(), 1e-40);  // rounding of the reference's 50 digits
  state = state_from(inertia_B, state.q_WB, Vector3(0, -7, 0.5));
  expect_exact("a start from rest");
}

// Kick, then drift: in short and long steps, with and without free steps before the kick, for bodies whose
// L_B moves and others.
TEST(Exact, DriftsFromTheMomentumThatAKickLeaves) {
  const Vector3 kick_W(0.3, -0.2, 0.5);
  for (const Vector3& inertia_B : {Vector3(1, 2, 3), Vector3(3, 1, 2), Vector3(2, 2, 2), Vector3(2, 2, 3)}) {
    for (const double speed : {0.0, 1.0, 100.0}) {
      RotationState state = state_from(inertia_B, kTilted, speed * Vector3(3, 2, 4));
      testing::RememberedBody body(*find_scheme("exact"));
      for (int i = 0; i < 6; ++i) {
        const Vector3 delta_omega_W = i % 3 == 1 ? Vector3::Zero() : kick_W;
        const Vector3 L_W =
            state.L_W + state.R_WB * inertia_B.cwiseProduct(state.R_WB.transpose() * delta_omega_W);
        const FreeTop truth(inertia_B, state.q_WB, L_W);
        body.step({inertia_B, delta_omega_W, kDt}, state);
        // measured 4.4e-16 (1 + speed) rad
        EXPECT_LE(truth.attitude_error(state.q_WB, kDt), 3e-15 * (1.0 + speed))
            << inertia_B.transpose() << " " << speed;
        EXPECT_LE((state.L_W - L_W).norm(), 1e-15 * L_W.norm());
      }
    }
  }
}

// Bit for bit, with an empty memory or one of an earlier motion, for L = 0 or nearly 0.
TEST(Exact, LeavesABodyAtRestAlone) {
  const Vector3 inertia_B(1, 2, 3);
  RandomBody random(13);
  for (const double speed : {0.0, 1e-150, -1e-170}) {
    testing::RememberedBody body(*find_scheme("exact"));
    for (int i = 0; i < 20; ++i) {
      const RotationState start = state_from(inertia_B, random.q_WB(), speed * Vector3(1, 2, 3));
      RotationState state = start;
      for (int step = 0; step < 3; ++step) body.step({inertia_B, Vector3::Zero(), kDt}, state);
      EXPECT_EQ(state.q_WB.coeffs(), start.q_WB.coeffs());
      EXPECT_LE((state.omega_W - start.omega_W).norm(), 1e-15 * std::abs(speed));
      if (i == 10) state = state_from(inertia_B, kTilted, Vector3(3, 2, 4));
      body.step({inertia_B, Vector3::Zero(), kDt}, state);
    }
  }
}

TEST(Exact, GivesANonFiniteStateWhereDoublePrecisionEnds) {
  RotationState state = state_from(Vector3(1, 2, 3), kTilted, Vector3(1e200, 1e200, 0));
  find_scheme("exact")->step({Vector3(1, 2, 3), Vector3::Zero(), kDt}, state);
  EXPECT_FALSE(state.all_finite());
}

}  // namespace
}  // namespace polhode
