// Properties specific to each scheme of the gallery: its order for several motions, the discrete equations
// that it solves, reversibility, and its declared failures.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "oracle/free_top.h"
#include "polhode/scheme_registry.h"
#include "support/free_motion_reference.h"
#include "support/random_body.h"

namespace polhode {
namespace {

using testing::angle_between;
using testing::state_from;

const Quaternion kTilted = Quaternion(0.5, 0.1, -0.7, 0.5).normalized();
const char* const kGallery[] = {"rk4", "axis_splitting", "implicit_midpoint", "moser_veselov",
                                "moser_veselov_4"};

RotationState start_of(const Vector3& inertia_B, const Vector3& omega_B) {
  return state_from(inertia_B, kTilted, kTilted * omega_B);
}

RotationState stepped(const char* scheme, const Vector3& inertia_B, RotationState state, double dt,
                      int steps = 1) {
  const SchemePointer found = find_scheme(scheme);
  for (int i = 0; i < steps; ++i) found->step({inertia_B, Vector3::Zero(), dt}, state);
  return state;
}

double energy_error(const RotationState& state, const RotationState& start) {
  return std::abs(state.energy() / start.energy() - 1.0);
}

// Physically possible bodies, including needles and plates, a third of them about to flip. Their second
// moments differ by up to `decades` powers of 10.
class PhysicalBodies {
 public:
  explicit PhysicalBodies(double decades = 3.0) : decades_(decades) {}

  Vector3 inertia_B() {
    const Vector3 second_moments(width(), width(), width());
    return Vector3::Constant(second_moments.sum()) - second_moments;
  }

  Vector3 omega_B(double speed) {
    Vector3 direction(normal_(generator_), normal_(generator_), normal_(generator_));
    if (++count_ % 3 == 0) direction = Vector3(0.01, 1.0, 0.01);
    return speed * direction.normalized();
  }

 private:
  double width() { return std::pow(10.0, -decades_ * uniform_(generator_)); }

  double decades_;
  std::mt19937 generator_{1};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
  int count_ = 0;
};

struct Motion {
  const char* name;
  Vector3 inertia_B;
  Vector3 omega_B;
  double turn;  ///< |omega| dt of the coarser run, rad
};

void PrintTo(const Motion& motion, std::ostream* stream) {
  *stream << motion.name;
}

class GalleryScheme : public ::testing::TestWithParam<std::tuple<const char*, Motion>> {};

TEST_P(GalleryScheme, ConvergesWithTheOrderItDeclares) {
  const auto& [scheme, motion] = GetParam();
  const RotationState start = start_of(motion.inertia_B, motion.omega_B);
  const oracle::FreeTop truth(motion.inertia_B, start.q_WB, start.L_W);
  const int steps = static_cast<int>(std::ceil(motion.omega_B.norm() / motion.turn));
  const auto error = [&, scheme = scheme, motion = motion](int count) {
    const RotationState end = stepped(scheme, motion.inertia_B, start, 1.0 / count, count);
    return truth.attitude_error_after(end.q_WB, count, 1.0 / count);
  };
  const double coarse = error(steps);
  const double fine = error(2 * steps);
  EXPECT_LE(coarse, 0.05);  // measured 1.6e-8 to 0.0126
  const int order = *find_scheme(scheme)->description().order;
  EXPECT_NEAR(std::log2(coarse / fine), order, 0.1);  // measured 1.996 to 2.009, 3.970 to 4.034
}

const Motion kMotions[] = {
    {"asymmetric", {1, 2, 3}, {3, 2, 4}, 0.05},
    {"rod", {2, 2, 0.5}, {1, 2, 5}, 0.05},
    {"disc", {1, 1, 1.9}, {1, -2, 5}, 0.05},
    {"ball", {2, 2, 2}, {3, 2, 4}, 0.05},
    {"about_to_flip", {1, 2, 3}, {0.01, 5, 0.02}, 0.05},
    {"flipping_t", {0.0025, 0.0042, 0.0066}, {0.1, 10, 0.1}, 0.05},
    {"large_steps", {1, 2, 3}, {4, 1, 2}, 0.15},
};

INSTANTIATE_TEST_SUITE_P(Registry, GalleryScheme,
                         ::testing::Combine(::testing::ValuesIn(kGallery), ::testing::ValuesIn(kMotions)),
                         [](const auto& instance) {
                           return std::string(std::get<0>(instance.param)) + "_" +
                                  std::get<1>(instance.param).name;
                         });

// Bit for bit, in any orientation: normalising a unit quaternion again could change it.
TEST(Gallery, LeavesABodyAtRestAsItIs) {
  testing::RandomBody random(3);
  for (const char* scheme : kGallery) {
    SCOPED_TRACE(scheme);
    for (int i = 0; i < 20; ++i) {
      const RotationState at_rest = state_from({1, 2, 3}, random.q_WB(), Vector3::Zero());
      const RotationState end = stepped(scheme, {1, 2, 3}, at_rest, 0.01, 3);
      EXPECT_EQ(end.q_WB.coeffs(), at_rest.q_WB.coeffs());
      EXPECT_EQ(end.omega_W, Vector3::Zero());
      EXPECT_EQ(end.L_W, Vector3::Zero());
    }
  }
}

TEST(Gallery, GoesBackTheWayItCameIfItIsSymmetricInTime) {
  const Vector3 inertia_B(1, 2, 3);
  const RotationState start = start_of(inertia_B, {3, 2, 4});
  const auto gap_after_there_and_back = [&](const char* scheme) {
    const RotationState there = stepped(scheme, inertia_B, start, 0.1, 20);
    return angle_between(stepped(scheme, inertia_B, there, -0.1, 20).q_WB, start.q_WB);
  };
  for (const char* scheme : {"axis_splitting", "implicit_midpoint", "moser_veselov", "moser_veselov_4"}) {
    EXPECT_LE(gap_after_there_and_back(scheme), 2e-14) << scheme;  // measured 5.2e-16 to 3.4e-15
  }
  EXPECT_GT(gap_after_there_and_back("rk4"), 0.005);  // measured 0.0196
}

TEST(Gallery, KeepsEnergyThroughManyLargeStepsWhereItSolvesAnEquation) {
  const Vector3 inertia_B(1, 2, 3);
  for (const Vector3& omega_B : {Vector3(3, 2, 4), Vector3(0.1, 5, 0.1)}) {
    const RotationState start = start_of(inertia_B, omega_B);
    for (const char* scheme : {"implicit_midpoint", "moser_veselov", "moser_veselov_4"}) {
      const RotationState end = stepped(scheme, inertia_B, start, 0.7 / omega_B.norm(), 20000);
      EXPECT_LE(energy_error(end, start), 5e-13) << scheme;  // measured 3.3e-14 to 1.3e-13
      EXPECT_EQ(end.L_W, start.L_W) << scheme;
    }
  }
}

// Body-frame momentum and turn of one step, computed from the result alone.
struct Turn {
  Vector3 start_L_B;
  Vector3 end_L_B;
  Quaternion rho_B;  // scalar part positive
};

Turn turn_of(const char* scheme, const Vector3& inertia_B, const Vector3& omega_B, double dt) {
  const RotationState start = start_of(inertia_B, omega_B);
  const RotationState end = stepped(scheme, inertia_B, start, dt);
  Quaternion rho_B = start.q_WB.conjugate() * end.q_WB;
  if (rho_B.w() < 0.0) rho_B.coeffs() = -rho_B.coeffs();
  return {start.R_WB.transpose() * start.L_W, end.R_WB.transpose() * end.L_W, rho_B};
}

// Returns I_1 e0 e1 - (I_2 - I_3) e2 e3 - (dt/2) L_1 and its cyclic permutations, relative to the largest
// moment: e is known to 1e-16.
double moser_veselov_residual(const Vector3& inertia_B, const Turn& turn, double dt) {
  Vector3 residual;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const Quaternion& e = turn.rho_B;
    residual[i] = inertia_B[i] * e.w() * e.vec()[i] -
                  (inertia_B[j] - inertia_B[k]) * e.vec()[j] * e.vec()[k] - 0.5 * dt * turn.start_L_B[i];
  }
  return residual.norm() / inertia_B.cwiseAbs().maxCoeff();
}

TEST(ImplicitMidpoint, SolvesEulersEquationsAtTheMidpointAndTurnsByTheirCayleyMap) {
  PhysicalBodies bodies;
  double residual = 0.0;
  double turn_error = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double dt = 0.01;
    const Vector3 inertia_B = bodies.inertia_B();
    const Turn turn = turn_of("implicit_midpoint", inertia_B, bodies.omega_B(i * 0.001 / dt), dt);
    if (i == 0) continue;  // at rest
    const Vector3 middle_L_B = 0.5 * (turn.start_L_B + turn.end_L_B);
    const Vector3 middle_omega_B = middle_L_B.cwiseQuotient(inertia_B);
    const Vector3 change_B = dt * middle_L_B.cross(middle_omega_B);
    residual = std::max(residual, (turn.end_L_B - turn.start_L_B - change_B).norm() / turn.start_L_B.norm());
    const Vector3 tangent_B = turn.rho_B.vec() / turn.rho_B.w();
    turn_error = std::max(turn_error, (tangent_B - 0.5 * dt * middle_omega_B).norm());
  }
  // The needles' moments, up to 1000 apart, amplify rounding.
  EXPECT_LE(residual, 1e-13);    // measured 3.4e-14
  EXPECT_LE(turn_error, 6e-14);  // measured 1.7e-14
}

TEST(MoserVeselov, SolvesTheDiscreteEquation) {
  PhysicalBodies bodies;
  double residual = 0.0;
  for (int i = 1; i < 2000; ++i) {
    const double dt = 0.01;
    const Vector3 inertia_B = bodies.inertia_B();
    const Turn turn = turn_of("moser_veselov", inertia_B, bodies.omega_B(0.99 * i / 2000 / dt), dt);
    residual = std::max(residual, moser_veselov_residual(inertia_B, turn, dt));
  }
  EXPECT_LE(residual, 1e-14);  // measured 2.3e-16
}

TEST(MoserVeselov4, SolvesTheDiscreteEquationForThePreprocessedMoments) {
  PhysicalBodies bodies;
  double residual = 0.0;
  for (int i = 1; i < 2000; ++i) {
    const double dt = 0.01;
    const Vector3 inertia_B = bodies.inertia_B();
    const Turn turn = turn_of("moser_veselov_4", inertia_B, bodies.omega_B(1.5 * i / 2000 / dt), dt);
    const auto [I1, I2, I3] = std::tuple(inertia_B.x(), inertia_B.y(), inertia_B.z());
    const double T = 0.5 * turn.start_L_B.dot(turn.start_L_B.cwiseQuotient(inertia_B));
    const double C = 0.5 * turn.start_L_B.dot(turn.start_L_B);
    const double s = -T / 3 * (1 / I1 + 1 / I2 + 1 / I3) + (I1 + I2 + I3) / (6 * I1 * I2 * I3) * C;
    const double d = (I1 + I2 + I3) / (6 * I1 * I2 * I3) * T - C / (3 * I1 * I2 * I3);
    Vector3 modified_B;
    for (int j = 0; j < 3; ++j) modified_B[j] = 1 / ((1 + dt * dt * s) / inertia_B[j] + dt * dt * d);
    residual = std::max(residual, moser_veselov_residual(modified_B, turn, dt));
  }
  EXPECT_LE(residual, 1e-14);  // measured 3.7e-15
}

// Errors after one second with I = (1, 2, 3), omega_B = (3, 2, 4).
TEST(MoserVeselov4, DividesItsErrorBy16FromASixtiethOn) {
  const RotationState start = start_of({1, 2, 3}, {3, 2, 4});
  const oracle::FreeTop truth({1, 2, 3}, start.q_WB, start.L_W);
  const auto error = [&](int steps) {
    const RotationState end = stepped("moser_veselov_4", {1, 2, 3}, start, 1.0 / steps, steps);
    return truth.attitude_error_after(end.q_WB, steps, 1.0 / steps);
  };
  // measured 2.09e-6, 1.30e-7, 8.15e-9, 5.09e-10
  EXPECT_NEAR(error(60), 2.09e-6, 0.01e-6);
  EXPECT_NEAR(error(120), 1.30e-7, 0.01e-7);
  EXPECT_NEAR(error(240), 8.15e-9, 0.01e-9);
  EXPECT_NEAR(error(480), 5.09e-10, 0.01e-10);
}

// Declared failures.

// Returns the angle by which a ball turns in a step.
double turn_of_a_ball(const char* scheme, double turn) {
  const Vector3 inertia_B(2, 2, 2);
  const RotationState start = start_of(inertia_B, {0, 0, turn});
  return angle_between(stepped(scheme, inertia_B, start, 1.0).q_WB, start.q_WB);
}

int failures_of_1000(const char* scheme, double turn, double decades = 3.0) {
  PhysicalBodies bodies(decades);
  int failures = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3 inertia_B = bodies.inertia_B();
    const RotationState end = stepped(scheme, inertia_B, start_of(inertia_B, bodies.omega_B(turn)), 1.0);
    failures += end.all_finite() ? 0 : 1;
  }
  return failures;
}

TEST(RungeKutta4, LosesEnergyUntilAPlainSpinAboutTheLargestMomentIsLeft) {
  const Vector3 inertia_B(1, 2, 3);
  const RotationState start = start_of(inertia_B, {3, 2, 4});
  const auto end_of = [&](double turn, int steps) {
    return stepped("rk4", inertia_B, start, turn / Vector3(3, 2, 4).norm(), steps);
  };
  const auto loss = [&](double turn, int steps) {
    return 1.0 - end_of(turn, steps).energy() / start.energy();
  };
  // At half the step the loss in the same time is 32 times smaller.
  EXPECT_NEAR(loss(0.2, 1000) / 1000, std::pow(0.2, 6) / 200, 1e-7);  // measured 3.4e-7
  EXPECT_NEAR(loss(0.2, 1000) / loss(0.1, 2000), 32.0, 1.0);          // measured 32.0
  const RotationState end = end_of(0.6, 20000);
  const double least_energy = start.L_W.squaredNorm() / (2.0 * inertia_B.z());
  EXPECT_NEAR(end.energy() / least_energy, 1.0, 4e-15);  // measured 6.7e-16
  EXPECT_GT(start.energy() / least_energy, 1.1);         // measured 1.15
}

// The stages rotate L without stretching it: a ball turns by the first five terms of the exponential series.
TEST(RungeKutta4, TurnsABallByTheSeriesOfTheExponential) {
  const double x = 0.5;
  const double turn = 2.0 * std::atan2(x / 2 - std::pow(x, 3) / 48, 1 - x * x / 8 + std::pow(x, 4) / 384);
  EXPECT_NEAR(turn_of_a_ball("rk4", x), turn, 2e-15);  // measured 1.7e-16
}

double largest_energy_error(const char* scheme, const Vector3& omega_B, double turn, int steps) {
  const Vector3 inertia_B(1, 2, 3);
  const RotationState start = start_of(inertia_B, omega_B);
  RotationState state = start;
  double largest = 0.0;
  for (int i = 0; i < steps; ++i) {
    state = stepped(scheme, inertia_B, state, turn / omega_B.norm());
    largest = std::max(largest, energy_error(state, start));
  }
  return largest;
}

TEST(AxisSplitting, SwingsInEnergyAndWandersInLargeSteps) {
  const auto swing = [&](double turn, int steps) {
    return largest_energy_error("axis_splitting", {3, 2, 4}, turn, steps);
  };
  EXPECT_NEAR(swing(0.1, 1000) / swing(0.05, 2000), 4.0, 0.1);  // measured 4.03
  EXPECT_LE(swing(0.5, 100000), 1.01 * swing(0.5, 1000));       // measured 6.18e-4, the same
  EXPECT_GT(swing(2.5, 10000), 0.5);                            // measured 1.597
}

// For such bodies Newton's method stalls at rounding.
TEST(Gallery, SolvesItsEquationsForTheSlenderestBodiesToo) {
  for (const char* scheme : {"implicit_midpoint", "moser_veselov", "moser_veselov_4"}) {
    for (const double turn : {1e-3, 0.1, 0.9})
      EXPECT_EQ(failures_of_1000(scheme, turn, 12.0), 0) << scheme << turn;
  }
}

TEST(ImplicitMidpoint, TurnsTooLittleAndFindsNoSolutionToSomeVeryLargeSteps) {
  EXPECT_NEAR(turn_of_a_ball("implicit_midpoint", 0.5), 2.0 * std::atan(0.25), 2e-15);    // measured 1.7e-16
  EXPECT_NEAR(turn_of_a_ball("implicit_midpoint", 100.0), 2.0 * std::atan(50.0), 2e-15);  // measured 0
  EXPECT_EQ(failures_of_1000("implicit_midpoint", 2.0), 0);
  EXPECT_NEAR(failures_of_1000("implicit_midpoint", 5.0), 47, 20);  // measured 47
}

TEST(MoserVeselov, TurnsTooMuchAndHasNoSolutionPastOneRadianAStep) {
  EXPECT_NEAR(turn_of_a_ball("moser_veselov", 0.5), std::asin(0.5), 2e-15);  // measured 2.2e-16
  EXPECT_EQ(failures_of_1000("moser_veselov", 0.99), 0);
  EXPECT_NEAR(failures_of_1000("moser_veselov", 1.01), 488, 50);  // measured 488
  EXPECT_EQ(failures_of_1000("moser_veselov", 1.3), 1000);
}

TEST(MoserVeselov4, TurnsLessAgainPastItsLimitAndThenHasNoSolution) {
  const auto turn = [](double omega_dt) { return turn_of_a_ball("moser_veselov_4", omega_dt); };
  EXPECT_NEAR(turn(0.5), std::asin(0.5 - 0.125 / 6.0), 2e-15);  // measured 5.6e-17
  EXPECT_GT(turn(1.4), turn(1.5));                              // measured 1.231, 1.215
  EXPECT_EQ(failures_of_1000("moser_veselov_4", 2.2), 0);
  EXPECT_NEAR(failures_of_1000("moser_veselov_4", 3.0), 831, 50);  // measured 831
}

// A step without a solution ends with a result that is not finite.
TEST(Gallery, EndsWhateverItIsGiven) {
  for (const char* scheme : kGallery) {
    SCOPED_TRACE(scheme);
    for (const double value : {std::nan(""), HUGE_VAL, 1e300, 1e-300}) {
      RotationState state = start_of({1, 2, 3}, {3, 2, 4});
      state.L_W.setConstant(value);
      const bool finite = stepped(scheme, {1, 2, 3}, state, 0.01).all_finite();
      EXPECT_TRUE(std::isfinite(value) || !finite) << value;
      stepped(scheme, {1e-300, 1, 1e300}, state, 0.01);
    }
  }
}

}  // namespace
}  // namespace polhode
