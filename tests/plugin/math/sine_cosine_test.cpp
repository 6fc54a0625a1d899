#include "math/sine_cosine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/same_bits.h"

namespace polhode::formulas {
namespace {

constexpr double kUlp = 2.2e-16;

// Returns the larger of the two absolute errors.
double error_of(const SineCosine<double>& found, double x) {
  const auto exact = static_cast<long double>(x);
  return static_cast<double>(
      std::max(std::abs(found.sine - std::sin(exact)), std::abs(found.cosine - std::cos(exact))));
}

TEST(SineCosine, OfSmallNumbersAreGoodToAnUlpOfOne) {
  double worst = 0.0;
  for (double x = -1.25; x <= 1.25; x += 1e-4)
    worst = std::max(worst, error_of(sine_cosine_series<11>(x), x));
  for (double x = -0.7854; x <= 0.7854; x += 1e-4) {
    worst = std::max(worst, error_of(sine_cosine_series<9>(x), x));
  }
  EXPECT_LE(worst, kUlp);  // measured 1.7e-16
  EXPECT_EQ(sine_cosine(0.0).sine, 0.0);
  EXPECT_EQ(sine_cosine(0.0).cosine, 1.0);
  for (double x = 1e-300; x < 0.7; x *= 3.0) {
    EXPECT_NEAR(sine_cosine(x).sine / std::sin(x), 1.0, 2 * kUlp) << x;  // measured 2.2e-16
  }
}

TEST(SineCosine, OfLargeNumbersAreGoodToAnUlpOfOne) {
  std::mt19937 generator(1);
  double worst = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const double x = std::uniform_real_distribution<double>(-1e6, 1e6)(generator);
    worst = std::max(worst, error_of(sine_cosine(x), x));
  }
  EXPECT_LE(worst, kUlp);  // measured 1.81e-16
}

// At these multiples the argument reduction cancels most, and the quadrant changes.
TEST(SineCosine, OfMultiplesOfAnEighthTurnAreGoodToAnUlpOfOne) {
  double worst = 0.0;
  for (int k = -600000; k <= 600000; k += k % 7 == 0 ? 1 : 13) {
    for (const double offset : {0.0, 1e-15, -1e-12, 1e-6}) {
      const double x = k * 0.78539816339744831 + offset;
      worst = std::max(worst, error_of(sine_cosine(x), x));
    }
  }
  EXPECT_LE(worst, kUlp);  // measured 1.89e-16
}

// An angle of 1e9 rad is itself known only to 1e-7.
TEST(SineCosine, OfHugeNumbersAreAsGoodAsTheirArgument) {
  for (double x = 1e6; x < 1e12; x *= 1.1) {
    EXPECT_LE(error_of(sine_cosine(x), x), kUlp * x) << x;  // measured 9.7e-17 x
  }
}

TEST(SineCosine, OfEightNumbersHaveTheBitsOfEach) {
  std::mt19937 generator(2);
  for (int i = 0; i < 10000; ++i) {
    Wide x;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      x.set(lane, std::pow(10.0, std::uniform_real_distribution<double>(-3.0, 7.0)(generator)));
    }
    const auto [sine, cosine] = sine_cosine(x);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const auto alone = sine_cosine(x[lane]);
      ASSERT_TRUE(testing::same_bits(sine[lane], alone.sine)) << x[lane];
      ASSERT_TRUE(testing::same_bits(cosine[lane], alone.cosine)) << x[lane];
    }
  }
}

}  // namespace
}  // namespace polhode::formulas
