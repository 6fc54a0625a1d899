#include "oracle/free_top.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "oracle/symmetric_top.h"
#include "oracle/taylor_top.h"
#include "support/random_body.h"

namespace polhode::oracle {
namespace {

const Quaternion kNoTurn = Quaternion::Identity();
const Quaternion kSomeTurn(0.3, -0.4, 0.5, 0.7);  // deliberately not normalised

struct FreeBody {
  const char* name;
  Vector3 inertia_B;
  Quaternion q_WB;
  Vector3 L_W;
  double duration;
};

void PrintTo(const FreeBody& body, std::ostream* out) {
  *out << body.name;
}

FreeTop top_of(const FreeBody& body) {
  return {body.inertia_B, body.q_WB, body.L_W};
}

const std::vector<FreeBody> kBodies = {
    {"AroundTheLargestMoment", {1, 2, 3}, kNoTurn, {3, 4, 12}, 2.0},
    {"AroundTheSmallestMoment", {1, 2, 3}, kNoTurn, {3, 2, 1}, 4.0},
    {"TurnedAsymmetric", {1, 2, 3}, kSomeTurn, {3, 2, 4}, 2.0},
    {"OtherOrderOfMoments", {3, 1, 2}, kSomeTurn, {-3, 2, -1}, 3.0},
    {"YetAnotherOrder", {2, 3, 1}, kSomeTurn, {3, -2, -5}, 2.0},
    {"NegativeComponents", {1, 2, 3}, kNoTurn, {-3, -2, -4}, 2.0},
    {"NegativeSmallest", {1, 2, 3}, kNoTurn, {-3, 2, -1}, 4.0},
    {"Prolate", {3, 3, 1}, kSomeTurn, {1, 2, 3}, 2.0},
    {"Oblate", {2, 5, 2}, kSomeTurn, {1, -2, 3}, 4.0},
    {"OblateAcrossItsAxis", {2, 2, 3}, kNoTurn, {1, 2, 0}, 4.0},
    {"ProlateAcrossItsAxis", {1, 3, 3}, kNoTurn, {0, 1, 2}, 4.0},
    {"ProlateAlongItsAxis", {1, 3, 3}, kNoTurn, {-2, 0, 0}, 2.0},
    {"Sphere", {2, 2, 2}, kSomeTurn, {1, 2, 3}, 3.0},
    {"SmallestAxisAlone", {1, 2, 3}, kNoTurn, {-5, 0, 0}, 1.0},
    {"MiddleAxisAlone", {1, 2, 3}, kNoTurn, {0, -5, 0}, 2.0},
    {"LargestAxisAlone", {1, 2, 3}, kNoTurn, {0, 0, 5}, 2.0},
    {"MiddleAxisFlipsOver", {1, 2, 3}, kNoTurn, {0.01, 10, -0.01}, 5.0},
    {"NearlyMiddleAxis", {1, 2, 3}, kNoTurn, {1e-14, 10, 1e-14}, 12.0},
    {"HandoutsT", {24.1449, 28.436, 118.812}, kNoTurn, {2.41449, 284.36, 0}, 5.0},
    // With moments 2, 3, 6 the separatrix is where L_1^2 = L_3^2.
    {"OnTheSeparatrix", {2, 3, 6}, kNoTurn, {1, 0.5, 1}, 10.0},
    {"OnTheSeparatrixTheOtherWay", {2, 3, 6}, kNoTurn, {-1, -2, 1}, 10.0},
    {"TurnedOnTheSeparatrix", {2, 3, 6}, Quaternion(1, 2, 2, 4), {0.625, 2.5625, 3.875}, 8.0},
    {"BesideTheSeparatrix", {2, 3, 6}, kNoTurn, {1, 0.5, std::nextafter(1.0, 2.0)}, 20.0},
    {"OnItsOtherSide", {2, 3, 6}, kNoTurn, {std::nextafter(1.0, 2.0), -0.5, -1}, 20.0},
    {"MomentsApart1e-4", {1, 1 + 1e-4, 1 - 1e-4}, kSomeTurn, {1, 2, 3}, 3.0},
    {"MomentsApart1e-8", {1 + 1e-8, 1, 1 - 2e-8}, kSomeTurn, {1, 2, 3}, 3.0},
    {"MomentsApart1e-14", {1, 1 - 1e-14, 1 + 1e-14}, kSomeTurn, {1, -2, 3}, 3.0},
    {"NearlyProlate", {3, 3 + 1e-14, 1}, kSomeTurn, {1, 2, 3}, 2.0},
    {"NearlyOblate", {2, 5, 2 - 1e-15}, kSomeTurn, {1, -2, 3}, 4.0},
    {"NoTriangle", {1, 20, 3}, kSomeTurn, {1, 2, 3}, 6.0},
    {"MomentsFarApart", {1e-3, 1, 1e3}, kNoTurn, {1e-3, 1, 100}, 0x1p-7},
    {"AtRest", {1, 2, 3}, kSomeTurn, {0, 0, 0}, 1e3},
    {"Fast", {1, 2, 3}, kSomeTurn, {1e6, 2e6, 3e6}, 0x1p-18},
    {"Slow", {1, 2, 3}, kSomeTurn, {1e-9, -2e-9, 3e-9}, 3e9},
    {"Small", {1e-12, 2e-12, 3e-12}, kSomeTurn, {1e-12, 2e-12, 3e-12}, 3.0},
};

class EachFreeBody : public ::testing::TestWithParam<FreeBody> {};

std::string test_name(const ::testing::TestParamInfo<FreeBody>& info) {
  std::string name = info.param.name;
  for (char& c : name) {
    if (c == '-') c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(FreeTop, EachFreeBody, ::testing::ValuesIn(kBodies), test_name);

// Rounding to double changes an orientation by about 1e-16 rad. Both oracles must measure that angle and
// agree in all its digits, so the comparison reaches far below double rounding.
void expect_same_motion(const FreeTop& top, TaylorTop& reference, double t_s, double L) {
  const Quaternion q_WB = reference.q_WB();
  EXPECT_NEAR(top.attitude_error(q_WB, t_s), reference.attitude_error(q_WB), 1e-31)
      << t_s;                                                                // measured 2.5e-32
  EXPECT_LT((top.q_WB(t_s).coeffs() - q_WB.coeffs()).norm(), 2e-16) << t_s;  // measured 4e-51, with the sign
  EXPECT_LE((top.L_B(t_s) - reference.L_B()).norm(), 2e-16 * L) << t_s;      // measured 2e-51
}

TEST_P(EachFreeBody, MovesAsEulersEquationsSay) {
  const FreeBody& body = GetParam();
  const FreeTop top = top_of(body);
  TaylorTop reference(body.inertia_B, body.q_WB, body.L_W);
  for (const int quarter : {0, 1, 2, 3, 4}) {
    expect_same_motion(top, reference, 0.25 * quarter * body.duration, body.L_W.norm());
    if (quarter < 4) reference.advance(0.25 * body.duration);
  }
  EXPECT_LT(reference.drift(), 2e-41);  // measured 4.2e-42
}

TEST(FreeTop, MovesAsEulersEquationsSayWhateverTheBody) {
  polhode::testing::RandomBody random(20);
  for (int i = 0; i < 20; ++i) {
    const Vector3 inertia_B = random.inertia_B(), omega_W = random.omega_W();
    const Quaternion q_WB = random.q_WB();
    const Vector3 L_W = q_WB * inertia_B.cwiseProduct(q_WB.conjugate() * omega_W);
    const double t_s = 5.0 * inertia_B.minCoeff() / L_W.norm();
    const FreeTop top(inertia_B, q_WB, L_W);
    TaylorTop reference(inertia_B, q_WB, L_W);
    reference.advance(t_s);
    expect_same_motion(top, reference, t_s, L_W.norm());
  }
}

TEST_P(EachFreeBody, StartsAtTheGivenOrientation) {
  const FreeBody& body = GetParam();
  EXPECT_LT(top_of(body).attitude_error(body.q_WB, 0.0), 4e-50);           // measured 7.9e-51
  EXPECT_LT(top_of(body).attitude_error_after(body.q_WB, 0, 1.0), 1e-18);  // measured 2.0e-19
}

TEST_P(EachFreeBody, KeepsItsMomentumAndEnergyForAnHour) {
  const FreeBody& body = GetParam();
  const FreeTop top = top_of(body);
  const double energy = top.at(0.0).energy();
  for (const double t_s : {0.1, 7.0, 100.0, 3600.0, -3600.0, 1e9}) {
    const RotationState state = top.at(t_s);
    EXPECT_LE((state.q_WB * top.L_B(t_s) - body.L_W).norm(), 1e-15 * body.L_W.norm())
        << t_s;                                                                    // measured 5.4e-16
    EXPECT_NEAR(state.energy(), energy, 5e-16 * energy) << t_s;                    // measured 2.6e-16
    EXPECT_NEAR(state.q_WB.norm(), 1.0, 2.5e-16) << t_s;                           // measured 1.2e-16
    EXPECT_LT((state.R_WB - state.q_WB.toRotationMatrix()).norm(), 1e-15) << t_s;  // measured 5.6e-16
    EXPECT_LE((state.R_WB * top.L_B(t_s).cwiseQuotient(body.inertia_B) - state.omega_W).norm(),
              1e-15 * state.omega_W.norm())
        << t_s;  // measured 3.6e-16
  }
}

TEST_P(EachFreeBody, IsTheSameEachTime) {
  const RotationState once = top_of(GetParam()).at(1234.5), again = top_of(GetParam()).at(1234.5);
  EXPECT_EQ(once.q_WB.coeffs(), again.q_WB.coeffs());
  EXPECT_EQ(once.omega_W, again.omega_W);
}

TEST_P(EachFreeBody, IsQuicklyComparedWithinARoundingOfTheExactComparison) {
  const FreeBody& body = GetParam();
  const FreeTop top = top_of(body);
  const double rate = body.L_W.norm() / body.inertia_B.minCoeff();
  // A step with few digits, so that its multiples are exact.
  const double dt = static_cast<float>(rate > 0.0 ? 10.0 / rate / 1024.0 : 1.0);
  for (const std::int64_t steps : {1, 1000, 3686400}) {  // the last one is an hour at 10 rad/s
    const double t_s = dt * static_cast<double>(steps);
    const Quaternion q_WB = top.q_WB(t_s);
    EXPECT_NEAR(top.attitude_error_after(q_WB, steps, dt), top.attitude_error(q_WB, t_s), 1e-18)
        << steps;  // measured 2.0e-19
  }
}

// Restarting from the state at t1 and advancing by t2 gives the state at t1 + t2, up to the growth of the
// rounding error at t1.
TEST(FreeTop, CanBeRestartedFromItsState) {
  for (const FreeBody& body : kBodies) {
    const double t1 = 0.375 * body.duration, t2 = 0.625 * body.duration;
    const FreeTop top = top_of(body);
    const FreeTop rest(body.inertia_B, top.q_WB(t1), body.L_W);
    // measured 3.3e-13 for the handout's T, which flips over; less than 3e-15 for the others
    EXPECT_LT(top.attitude_error(rest.q_WB(t2), t1 + t2), 1e-12) << body.name;
  }
}

TEST(FreeTop, ComesBackAfterAnHour) {
  const Vector3 inertia_B(1, 2, 3), L_W(10, 8, 20);  // about 12 rad/s
  const FreeTop top(inertia_B, kSomeTurn, L_W);
  const FreeTop later(inertia_B, top.q_WB(3600.0), L_W);
  EXPECT_LT(later.attitude_error(kSomeTurn, -3600.0), 2e-12);  // measured 6.0e-13
}

void expect_that_it_ends_about_the_middle_axis(const FreeTop& top, double L) {
  for (const double t_s : {200.0, 1e4, 1e9, 1e300}) {
    const Vector3 L_B = top.L_B(t_s);
    EXPECT_LT((L_B.cwiseAbs() - Vector3(0, L, 0)).norm(), 1e-21) << t_s;  // measured 4.1e-22
    EXPECT_EQ(L_B.y(), -top.L_B(-t_s).y()) << "it turned over since " << -t_s;
  }
}

TEST(FreeTop, ComesToTurnAboutItsMiddleAxisOnTheSeparatrix) {
  expect_that_it_ends_about_the_middle_axis(FreeTop({2, 3, 6}, kNoTurn, {1, 0.5, 1}), 1.5);
}

// L_B is a multiple of (1, 2, 2). Moments, orientation and momentum have some 50 binary digits each: only
// exact products, which need more than 50 decimal digits, show that the body is on the separatrix.
TEST(FreeTop, SeesThatItIsOnTheSeparatrixWhateverTheDigits) {
  const double of_inertia = 0x1.3ff1722c566bp0, of_q = 0x1.4ab7a473d293p0, of_L = 0x1.cda0e546aaf7p0;
  const FreeTop top(of_inertia * Vector3(3, 6, 8), Quaternion(of_q, 2 * of_q, 2 * of_q, 4 * of_q),
                    of_L * Vector3(5, 2, 14));
  expect_that_it_ends_about_the_middle_axis(top, of_L * 15);
}

TEST(FreeTop, IsASymmetricTopWhereTwoMomentsAreEqual) {
  for (const double axial : {0.1, 1.0, 1.5, 2.0, 5.0}) {
    const Vector3 L_W(1, -2, 3);
    const FreeTop top({1.5, 1.5, axial}, kSomeTurn, L_W);
    const SymmetricTop symmetric(1.5, axial, kSomeTurn, L_W);
    for (const double t_s : {0.0, 0.3, 2.0, -5.0}) {
      EXPECT_LT(top.attitude_error(symmetric.at(t_s).q_WB, t_s), 1e-13)
          << axial << " " << t_s;  // measured 4.4e-14
      EXPECT_LT((top.at(t_s).omega_W - symmetric.at(t_s).omega_W).norm(), 1e-13)
          << axial << " " << t_s;  // measured 3.4e-14
    }
  }
}

TEST(FreeTop, SeesAnAngleFarBelowTheRoundingOfADouble) {
  const FreeTop top({1, 2, 3}, kNoTurn, {1, 2, 3});
  EXPECT_EQ(top.attitude_error(Quaternion(1, 0, 1e-25, 0), 0.0), 2e-25);
  EXPECT_EQ(top.attitude_error(Quaternion(-8, 0, 0, 8e-25), 0.0), 2e-25) << "of any length, either sign";
  EXPECT_NEAR(top.attitude_error(Quaternion(0, 1, 0, 0), 0.0), std::acos(-1.0), 1e-15);  // measured 0
}

TEST(FreeTop, RejectsInvalidArguments) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(FreeTop({1, 0, 3}, kNoTurn, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(FreeTop({1, -2, 3}, kNoTurn, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(FreeTop({1, nan, 3}, kNoTurn, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(FreeTop({1, 2, 3}, Quaternion(0, 0, 0, 0), {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(FreeTop({1, 2, 3}, kNoTurn, {1, nan, 3}), std::invalid_argument);
}

}  // namespace
}  // namespace polhode::oracle
