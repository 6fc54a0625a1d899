#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "oracle/many_digits.h"

/// The theta functions in the free top's Cayley-Klein parameters, derived in free_top.cpp.
namespace polhode::oracle {

/// Terms below this fraction of the largest term are dropped.
template <class R>
Real negligible() {
  return Real(std::numeric_limits<R>::epsilon()) / 16;
}

/// a and b without their phase, up to a common factor, for nomes at which the series in cosines converges
/// fast. With p = e^(epsilon - pi K'/2K) and x = pi u/2K, theta4 has the even and theta1 the odd terms of
/// q^(k(k-1)/2) p^k e^(ikx) and q^(k(k+1)/2) p^-k e^(-ikx).
template <class R>
class CircularSeries {
 public:
  CircularSeries() = default;
  CircularSeries(const Real& nome, const Real& p) {
    const Real nome_by_p = p == 0 ? Real(0) : Real(nome / p);
    Real plus = 1, minus = 1, power = 1;
    add(1, 0);
    for (int k = 1; plus > negligible<R>(); ++k) {
      plus *= power * p;
      minus *= power * nome_by_p;
      power *= nome;
      const int sign = k / 2 % 2 == 0 ? 1 : -1;
      add(sign * (plus + minus), sign * (plus - minus));
    }
  }

  Rotation<R> at(const R& x) const {
    using std::cos, std::sin;
    const R cos_x = cos(x), sin_x = sin(x);
    Rotation<R> result(0, 0, 0, 0);
    R cosine = 1, sine = 0;  // cos(k x), sin(k x)
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      if (k % 2 == 0) {
        result.w() += sums_[k] * cosine;
        result.z() += differences_[k] * sine;
      } else {
        result.x() += sums_[k] * sine;
        result.y() -= differences_[k] * cosine;
      }
      const R next_cosine = cosine * cos_x - sine * sin_x;
      sine = sine * cos_x + cosine * sin_x;
      cosine = next_cosine;
    }
    return result;
  }

  /// d(arg a)/dx at x = 0.
  R rate_of_argument() const {
    R sum = 0, derivative = 0;
    for (std::size_t k = 0; k < sums_.size(); k += 2) {
      sum += sums_[k];
      derivative += static_cast<int>(k) * differences_[k];
    }
    return derivative / sum;
  }

 private:
  void add(const Real& sum, const Real& difference) {
    sums_.push_back(static_cast<R>(sum));
    differences_.push_back(static_cast<R>(difference));
  }

  std::vector<R> sums_, differences_;
};

/// a and b near the separatrix, at zeta' = psi + i w with w = pi u/4K', |u| <= K. theta2 and theta1 have the
/// terms nome^(n^2 + n) e^(+-(2n + 1)(w - i psi)), here divided by e^|w|, which could overflow.
template <class R>
class HyperbolicSeries {
 public:
  HyperbolicSeries() = default;
  HyperbolicSeries(const Real& nome, const Real& psi) {
    Real square_power = 1, power = 1;  // nome^(n^2), nome^n
    for (int n = 0; square_power > negligible<R>(); ++n) {
      const Real angle = (2 * n + 1) * psi;
      terms_.push_back({static_cast<R>(square_power), static_cast<R>(Real(square_power * power)),
                        static_cast<R>(Real(cos(angle))), static_cast<R>(Real(sin(angle)))});
      square_power *= power * power * nome;
      power *= nome;
    }
  }

  /// `decay` is e^-|w|; `growth` is nome e^2|w|, which is 1 at the end of the period.
  Rotation<R> at(const R& decay, const R& growth, bool negative) const {
    Rotation<R> result(0, 0, 0, 0);
    const R decay_squared = decay * decay;
    R growing = 1, decaying = decay_squared;
    int sign = 1;
    for (const Term& term : terms_) {
      const R large = growing * term.growing, small = decaying * term.decaying;
      result.w() += (large + small) * term.cosine;
      result.z() -= (large - small) * term.sine;
      result.x() += sign * (large - small) * term.cosine;
      result.y() -= sign * (large + small) * term.sine;
      growing *= growth;
      decaying *= decay_squared;
      sign = -sign;
    }
    if (negative) {  // a(-u) = a*, b(-u) = -b*
      result.z() = -result.z();
      result.x() = -result.x();
    }
    return result;
  }

  /// d(arg a)/dw at w = 0.
  R rate_of_argument() const {
    R sum = 0, derivative = 0;
    int odd = 1;
    for (const Term& term : terms_) {
      sum += term.decaying * term.cosine;
      derivative -= odd * term.decaying * term.sine;
      odd += 2;
    }
    return derivative / sum;
  }

 private:
  struct Term {
    R growing, decaying, cosine, sine;
  };
  std::vector<Term> terms_;
};

}  // namespace polhode::oracle
