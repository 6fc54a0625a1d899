#include "math/jacobi_functions.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

namespace polhode::formulas {
namespace {

constexpr double kUlp = 2.2e-16;

TEST(JacobiFunctions, AgreeWithBoostsOverTheirWholeRange) {
  double worst = 0.0;
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const long double x = 0.01L * (i == 0 ? 1e-6L : i);
      const long double m = j / 20.0L;
      long double cn = 0.0, dn = 0.0;
      const long double sn = boost::math::jacobi_elliptic(std::sqrt(m), x, &cn, &dn);
      const JacobiFunctions found = jacobi_functions(static_cast<double>(x), static_cast<double>(m));
      const auto error = [](double value, long double expected) {
        return std::abs(static_cast<double>(value / expected - 1.0L));
      };
      worst =
          std::max({worst, error(found.sn_per_argument, sn / x), error(found.cn, cn), error(found.dn, dn)});
    }
  }
  EXPECT_LE(worst, 5 * kUlp);  // measured 0.6
}

TEST(JacobiFunctions, OfZeroAreOne) {
  const JacobiFunctions at_zero = jacobi_functions(0.0, 0.3);
  EXPECT_EQ(at_zero.sn_per_argument, 1.0);
  EXPECT_EQ(at_zero.cn, 1.0);
  EXPECT_EQ(at_zero.dn, 1.0);
}

TEST(CompleteEllipticIntegral, AgreesWithBoostsUpToTheSeparatrix) {
  double worst = 0.0;
  for (double m1 = 1.0; m1 > 1e-3; m1 *= 0.9) {
    const auto expected = static_cast<double>(boost::math::ellint_1(std::sqrt(1.0L - m1)));
    worst = std::max(worst, std::abs(complete_elliptic_integral(m1) / expected - 1.0));
  }
  EXPECT_LE(worst, 5 * kUlp);  // measured 1.5
  // K = ln(4/sqrt(m1)) (1 + m1/4) - m1/4 + O(m1^2 ln m1) (DLMF 19.12.1)
  for (const double m1 : {1e-9, 1e-20, 1e-40}) {
    const double logarithm = std::log(4.0 / std::sqrt(m1));
    EXPECT_NEAR(complete_elliptic_integral(m1), logarithm + m1 / 4.0 * (logarithm - 1.0), 5e-14);
  }
}

}  // namespace
}  // namespace polhode::formulas
