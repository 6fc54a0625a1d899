#pragma once

namespace polhode::free_top {

/// Jacobi's elliptic functions of a small argument.
struct JacobiFunctions {
  double sn_per_argument;  ///< sn(x|m)/x, 1 at x = 0
  double cn;
  double dn;
};

/// |x| <= 0.6, parameter 0 <= m <= 1 (m = k^2). Relative error of each: a few ulp.
JacobiFunctions jacobi_functions(double x, double m);

/// The complete integral K from the complementary parameter m1 = 1 - m > 0, by the arithmetic-geometric mean
/// (DLMF 19.8.5). K(m) is a quarter of the functions' period.
double complete_elliptic_integral(double m1);

}  // namespace polhode::free_top
