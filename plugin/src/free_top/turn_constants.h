#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "free_top/motion.h"
#include "math/jacobi_functions.h"
#include "math/sine_cosine.h"

/// The turn of the body in a substep is rho = (e0, e) with e0 e_i = mu_i (L_i + L'_i). This is the form of
/// the discrete Moser-Veselov equations, with three constants mu_i that make it exact. Real is double or
/// Wide.
///
/// Sources: J. Moser, A. P. Veselov, Commun. Math. Phys. 139 (1991) 217; R. van Zon, J. Schofield, J. Comput.
/// Phys. 225 (2007) 145; E. Celledoni, F. Fasso, N. Safstrom, A. Zanna, SIAM J. Sci. Comput. 30 (2008) 2084.
namespace polhode::free_top {

using formulas::JacobiFunctions, formulas::SnSeries;

/// Returns J. The turn about L from -h/2 to h/2, with L_2 = 0 in the middle, is psi = integral of
/// (a3 u3 + 2T h/|L|)/(1 + u3) d(t/h) with u3 = C dn(nu t). This equals 2T h/|L| - n J with
/// J = integral of u3/(1 + u3). The integrand is even. Gauss-Legendre quadrature with 10 nodes, 5 by
/// symmetry, is accurate to rounding for nu h <= 1.2.
template <class Real>
POLHODE_INLINE Real mean_of_dn_term(const Motion<Real>& motion, const SnSeries<Real>& series) {
  using std::sqrt;
  constexpr std::array<double, 5> kNode = {0.14887433898163121088, 0.43339539412924719080,
                                           0.67940956829902440623, 0.86506336668898451073,
                                           0.97390652851717172008};
  constexpr std::array<double, 5> kWeight = {0.29552422471475287017, 0.26926671930999635509,
                                             0.21908636251598204400, 0.14945134915058059315,
                                             0.06667134430868813759};
  Real sum = 0.0;
  for (std::size_t i = 0; i < kNode.size(); ++i) {
    const Real x2 = motion.nu_h2 * (0.25 * kNode[i] * kNode[i]);
    // dn^2 = 1 - m sn^2 = (w - m x^2)/w with w = x^2/sn^2, and so u3/(1 + u3) = g/(w + g):
    const Real w = series.x2_per_sn2(x2);
    const Real g = motion.C * sqrt(w * (w - motion.m * x2));
    sum += kWeight[i] * (g / (w + g));
  }
  return sum;
}

/// Returns mu for unit momentum. The increment of the symmetric step is
/// rho = arc(u-)^-1 (cos psi/2, e3 sin psi/2) arc(u+), with arc(u) the shortest rotation that takes u to
/// axis 3, u+- = (A c0, +-B s0, C d0), and s0, c0, d0 the functions of nu h/2. With `a` = A c0, b = B s0 and
/// u3 = C d0 this is
///   e0 = c (1 - b^2/(1 + u3)) - s ab/(1 + u3),  e1 = b c + a s,  e3 = s (u3 + b^2/(1 + u3)) - c ab/(1 + u3)
/// mu_1 = e0 e1/(2 A c0), mu_3 = e0 e3/(2 C d0), in which A and C cancel; and
/// mu_2 = mu_1 - e0^2 d21/K = mu_3 + e0^2 d32/K with K = 2 c0 d0 nu h/s0, where the smaller difference
/// cancels least.
template <class Real>
POLHODE_INLINE Triple<Real> turn_constants(const Motion<Real>& motion, const JacobiFunctions<Real>& half,
                                           const Real& psi) {
  using std::abs;
  const auto [s, c] = formulas::sine_cosine_series<11>(Real(0.5 * psi));
  const Real s0_per_nu_h = 0.5 * half.sn_per_argument;
  const Real u3 = motion.C * half.dn;
  const Real a = motion.A * half.cn;
  const Real b_per_u3 = motion.A * motion.d31 * s0_per_nu_h / half.dn;
  const Real b = b_per_u3 * u3;
  const Real per_one_plus_u3 = 1.0 / (1.0 + u3);
  const Real e0 = c - b * (b * c + a * s) * per_one_plus_u3;
  const Real mu_1 = 0.5 * e0 * (s + motion.d31 * s0_per_nu_h * motion.C * c / half.cn);
  const Real mu_3 = 0.5 * e0 * (s + b_per_u3 * (b * s - a * c) * per_one_plus_u3);
  const Real e0_squared_per_K = e0 * e0 * s0_per_nu_h / (2.0 * half.cn * half.dn);
  const Real mu_2 = select(abs(motion.d21) < abs(motion.d32), Real(mu_1 - motion.d21 * e0_squared_per_K),
                           Real(mu_3 + motion.d32 * e0_squared_per_K));
  return {mu_1, mu_2, mu_3};
}

}  // namespace polhode::free_top
