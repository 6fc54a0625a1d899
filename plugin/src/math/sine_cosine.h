#pragma once

#include <array>
#include <cstddef>

#include "simd/wide.h"

/// Sine and cosine, by the same operations for Real = double and Real = Wide. The standard library's
/// functions differ in the last bit between processors.
namespace polhode::formulas {

template <class Real>
struct SineCosine {
  Real sine, cosine;
};

/// Returns sin(x)/x and cos(x) from x^2 by Taylor's series: 11 terms of each for |x| <= 1.25, 9 for
/// |x| <= pi/4, 8 for |x| <= pi/8. Error: one ulp.
template <std::size_t terms, class Real>
POLHODE_INLINE SineCosine<Real> sinc_cosine_series(const Real& x2) {
  // 1/(2k)! with alternating signs. The first omitted terms are below 2e-18.
  constexpr std::array<double, 11> kCosine = {1.0,
                                              -1.0 / 2,
                                              1.0 / 24,
                                              -1.0 / 720,
                                              1.0 / 40320,
                                              -1.0 / 3628800,
                                              1.0 / 479001600,
                                              -1.0 / 87178291200,
                                              1.0 / 20922789888000,
                                              -1.0 / 6402373705728000,
                                              1.0 / 2432902008176640000};
  // 1/(2k + 1)! with alternating signs.
  constexpr std::array<double, 11> kSinc = [&kCosine] {
    std::array<double, 11> result{};
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = kCosine[k] / static_cast<double>(2 * k + 1);
    return result;
  }();
  Real cosine = kCosine[terms - 1];
  Real sinc = kSinc[terms - 1];
  for (std::size_t k = terms - 1; k-- > 0;) {
    cosine = kCosine[k] + x2 * cosine;
    sinc = kSinc[k] + x2 * sinc;
  }
  return {sinc, cosine};
}

/// Returns sine and cosine of small x, as sinc_cosine_series. The error of the sine is one ulp of x if
/// |x| < 1.
template <std::size_t terms, class Real>
POLHODE_INLINE SineCosine<Real> sine_cosine_series(const Real& x) {
  const auto [sinc, cosine] = sinc_cosine_series<terms>(Real(x * x));
  return {x * sinc, cosine};
}

/// Returns the nearest integer, the even one if there are two. Requires |x| < 2^51.
template <class Real>
POLHODE_INLINE Real nearest_integer(const Real& x) {
  constexpr double kShift = 6755399441055744.0;  // 1.5 * 2^52: nearby doubles are integers
  const Real shifted = x + kShift;
  return shifted - kShift;
}

/// Returns sine and cosine of any x. Error: one ulp of 1 up to 1e6 rad; beyond that, half an ulp of x in
/// addition.
template <class Real>
POLHODE_INLINE SineCosine<Real> sine_cosine(const Real& x) {
  // x = k pi/2 + r, with pi/2 in three parts (W. J. Cody, W. Waite, Software Manual for the Elementary
  // Functions, 1980). The first two parts have 33 bits each, so that their products with k < 2^20 are exact.
  constexpr double kHalfPi1 = 1.57079632673412561417e+00;
  constexpr double kHalfPi2 = 6.07710050630396597660e-11;
  constexpr double kHalfPi3 = 2.02226624879595063154e-21;
  constexpr double kPerHalfPi = 0.63661977236758134308;
  const Real k = nearest_integer(Real(x * kPerHalfPi));
  const Real r = ((x - k * kHalfPi1) - k * kHalfPi2) - k * kHalfPi3;
  const auto [s, c] = sine_cosine_series<9>(r);
  const Real quadrant = k - 4.0 * nearest_integer(Real(0.25 * k));  // -2, -1, 0, 1 or 2
  const Real square = quadrant * quadrant;
  const auto is_odd = square == 1.0;
  const auto is_opposite = square == 4.0;
  const Real sine = select(is_odd, c, s);
  const Real cosine = select(is_odd, s, c);
  return {select(is_opposite | (quadrant == -1.0), Real(-sine), sine),
          select(is_opposite | (quadrant == 1.0), Real(-cosine), cosine)};
}

}  // namespace polhode::formulas
