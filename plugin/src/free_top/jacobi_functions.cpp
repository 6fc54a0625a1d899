#include "free_top/jacobi_functions.h"

#include <cmath>

namespace polhode::free_top {

namespace {

// Below this argument the first term left out of the series is under 1e-16 of sn for every m.
constexpr double kSeriesArgument = 0.04;

// sn(x|m)/x to x^8 (DLMF 22.10.4).
double sn_series(double x2, double m) {
  const double c3 = -(1.0 + m) / 6.0;
  const double c5 = (1.0 + m * (14.0 + m)) / 120.0;
  const double c7 = -(1.0 + m * (135.0 + m * (135.0 + m))) / 5040.0;
  const double c9 = (1.0 + m * (1228.0 + m * (5478.0 + m * (1228.0 + m)))) / 362880.0;
  return 1.0 + x2 * (c3 + x2 * (c5 + x2 * (c7 + x2 * c9)));
}

}  // namespace

JacobiFunctions jacobi_functions(double x, double m) {
  int doublings = 0;
  double small_x = x;
  while (std::abs(small_x) > kSeriesArgument) {
    small_x *= 0.5;
    ++doublings;
  }
  const double x2 = small_x * small_x;
  const double series = sn_series(x2, m);
  // sn^2(2x) = 4 sn^2 (1 - sn^2) (1 - m sn^2) / (1 - m sn^4)^2 (DLMF 22.6.5), here for r = (sn/x)^2, where
  // the 4 cancels. cn and dn are taken from sn at the end only, else each doubling would double their error.
  double r = series * series;
  double argument2 = x2;
  for (int i = 0; i < doublings; ++i) {
    const double sn2 = r * argument2;
    const double denominator = 1.0 - m * sn2 * sn2;
    r *= (1.0 - sn2) * (1.0 - m * sn2) / (denominator * denominator);
    argument2 *= 4.0;
  }
  const double sn2 = r * argument2;
  return {std::sqrt(r), std::sqrt(1.0 - sn2), std::sqrt(1.0 - m * sn2)};
}

double complete_elliptic_integral(double m1) {
  constexpr double kHalfPi = 1.57079632679489661923;
  constexpr double kConverged = 1e-8;  // the mean converges quadratically
  double a = 1.0;
  double g = std::sqrt(m1);
  while (a - g > kConverged * a) {
    const double mean = 0.5 * (a + g);
    g = std::sqrt(a * g);
    a = mean;
  }
  return kHalfPi / (0.5 * (a + g));
}

}  // namespace polhode::free_top
