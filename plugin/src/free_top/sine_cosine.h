#pragma once

#include <array>
#include <cstddef>

#include "lanes/lanes.h"

namespace polhode::free_top {

template <class Real>
struct SineCosine {
  Real sine, cosine;
};

/// Of |x| <= 1.25, by Taylor's series in the same operations for a double as for Lanes. Error: an ulp of 1.
template <class Real>
POLHODE_INLINE SineCosine<Real> sine_cosine(const Real& x) {
  // 1/(2k)! and 1/(2k+1)!, in turns of one sign; the first terms left out are under 1e-18.
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
  Real cosine = kCosine.back();
  Real sine = kCosine.back() / 21.0;
  const Real x2 = x * x;
  for (std::size_t k = kCosine.size() - 1; k-- > 0;) {
    cosine = kCosine[k] + x2 * cosine;
    sine = kCosine[k] / static_cast<double>(2 * k + 1) + x2 * sine;
  }
  return {x * sine, cosine};
}

}  // namespace polhode::free_top
