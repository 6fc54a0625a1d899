#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "simd/wide.h"

/// Jacobi's elliptic functions of a small argument. Real is double or Wide.
namespace polhode::formulas {

/// x^2/sn^2(x|m) by its power series, for |x| <= 0.6 and 0 <= m <= 1 (m = k^2). Relative error: one ulp.
///
/// 1/sn^2 is Weierstrass' function plus (1 + m)/3 (DLMF 23.6(ii)) and so has the series 23.9.2, with
/// g2 = 4 (1 - m + m^2)/3 and g3 = 4 (m - 2) (2m - 1) (m + 1)/27. Its poles are the zeros of sn, which are at
/// least pi away for every m: twice as far as the poles of sn itself.
template <class Real>
class SnSeries {
 public:
  POLHODE_INLINE explicit SnSeries(const Real& m) {
    c_[1] = (1.0 + m) / 3.0;
    c_[2] = (1.0 - m * (1.0 - m)) / 15.0;
    c_[3] = (m - 2.0) * (2.0 * m - 1.0) * (m + 1.0) / 189.0;
    for (std::size_t n = 4; n <= kTerms; ++n) {  // DLMF 23.9.5, whose sum is symmetric
      Real half_sum = n % 2 == 0 ? Real(0.5 * c_[n / 2] * c_[n / 2]) : Real(0.0);
      for (std::size_t k = 2; 2 * k < n; ++k) half_sum += c_[k] * c_[n - k];
      c_[n] = half_sum * (6.0 / static_cast<double>((2 * n + 1) * (n - 3)));
    }
  }

  POLHODE_INLINE Real x2_per_sn2(const Real& x2) const {
    Real sum = c_[kTerms];
    for (std::size_t n = kTerms - 1; n >= 1; --n) sum = c_[n] + x2 * sum;
    return 1.0 + x2 * sum;
  }

 private:
  static constexpr std::size_t kTerms = 12;  // the next term is below 1e-17
  std::array<Real, kTerms + 1> c_;
};

template <class Real>
struct JacobiFunctions {
  Real sn_per_argument;  ///< sn(x|m)/x, 1 at x = 0
  Real cn;
  Real dn;
};

/// Computes the functions with a relative error of a few ulp each.
template <class Real>
POLHODE_INLINE JacobiFunctions<Real> jacobi_functions(const SnSeries<Real>& series, const Real& x2,
                                                      const Real& m) {
  using std::sqrt;
  const Real r = 1.0 / series.x2_per_sn2(x2);
  const Real sn2 = r * x2;
  return {sqrt(r), sqrt(1.0 - sn2), sqrt(1.0 - m * sn2)};
}

template <class Real>
JacobiFunctions<Real> jacobi_functions(const Real& x, const Real& m) {
  return jacobi_functions(SnSeries<Real>(m), Real(x * x), m);
}

/// Returns the complete integral K for the complementary parameter m1 = 1 - m > 0, by the
/// arithmetic-geometric mean (DLMF 19.8.5). K(m) is a quarter of the functions' period.
double complete_elliptic_integral(double m1);

}  // namespace polhode::formulas
