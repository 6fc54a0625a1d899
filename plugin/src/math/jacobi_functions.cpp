#include "math/jacobi_functions.h"

namespace polhode::formulas {

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

}  // namespace polhode::formulas
