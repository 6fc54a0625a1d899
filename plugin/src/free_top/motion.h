#pragma once

#include <cmath>

#include "free_top/labels.h"

/// A step of a free motion. Real is double or Wide.
///
/// All quantities are dimensionless: u = L/|L|, the angles a_i = |L| h / I_i and their differences.
/// Everything else is a sum of terms of one sign, so that nothing cancels:
///   d_ij = a_j - a_i = |L| h (I_i - I_j) / (I_i I_j)
///   n = u1^2 d31 + u2^2 d32,  p = u2^2 d21 + u3^2 d31           (the two invariants, (nu h)^2 = d32 p)
///   A^2 = n / d31,  B^2 = n / d32,  C^2 = p / d31,  m = d21 n / (d32 p)
/// Then u = (A cn, +-B sn, +-C dn)(nu t + phase | m) (L. D. Landau, E. M. Lifshitz, Mechanics, section 37).
namespace polhode::free_top {

/// A substep turns by less than this, rad: the square root in `turn_of` is valid below pi/2. Also the largest
/// nu h for which the quadrature and the series are accurate to rounding.
inline constexpr double kLongestSubstep = 1.2;

/// An invariant below this counts as zero: L then does not move in the body.
inline constexpr double kNothing = 1e-290;

/// Smallest complement 1 - m. On the separatrix the period is infinite; with this complement it is 188 / nu.
inline constexpr double kLeastComplement = 1e-40;

template <class Real>
struct Motion {
  Real d21, d31, d32;
  Real n, p;
  Real energy_angle;  ///< 2 T h / |L|: the angle by which the body turns about L, averaged over all axes
  Real A, C;
  Real m, m1;  ///< m1 = 1 - m
  Real nu_h2;  ///< (nu h)^2
  Real turn2;  ///< square of the largest |omega| h on the polhode, rad^2

  /// Returns the same motion over a part of the step.
  Motion over(const Real& part) const {
    Motion shorter = *this;
    for (Real* angle :
         {&shorter.d21, &shorter.d31, &shorter.d32, &shorter.n, &shorter.p, &shorter.energy_angle}) {
      *angle *= part;
    }
    for (Real* squared : {&shorter.nu_h2, &shorter.turn2}) *squared *= square(part);
    return shorter;
  }
};

template <class Real>
POLHODE_INLINE Real ratio(const Real& numerator, const Real& denominator) {
  return select(denominator == 0.0, Real(0.0), numerator / denominator);
}

/// Returns the motion for a step of h. `length_times_h` is |L| h.
template <class Real>
POLHODE_INLINE Motion<Real> motion_of(const Triple<Real>& inertia, const Triple<Real>& u,
                                      const Real& length_times_h) {
  using std::max;
  using std::min;
  using std::sqrt;
  const Triple<Real> u2 = {square(u[0]), square(u[1]), square(u[2])};
  const Triple<Real> a = {length_times_h / inertia[0], length_times_h / inertia[1],
                          length_times_h / inertia[2]};
  Motion<Real> motion;
  const auto difference = [&](std::size_t i, std::size_t j) {
    return Real(length_times_h * (inertia[i] - inertia[j]) / (inertia[i] * inertia[j]));
  };
  motion.d21 = difference(1, 0);
  motion.d31 = difference(2, 0);
  motion.d32 = difference(2, 1);
  motion.n = u2[0] * motion.d31 + u2[1] * motion.d32;
  motion.p = u2[1] * motion.d21 + u2[2] * motion.d31;
  motion.energy_angle = a[0] * u2[0] + a[1] * u2[1] + a[2] * u2[2];
  const Real A2 = ratio(motion.n, motion.d31);
  const Real B2 = ratio(motion.n, motion.d32);
  const Real C2 = ratio(motion.p, motion.d31);
  motion.A = sqrt(A2);
  motion.C = sqrt(C2);
  motion.nu_h2 = motion.d32 * motion.p;
  motion.turn2 = square(a[0]) * A2 + square(a[1]) * min(Real(1.0), B2) + square(a[2]) * C2;
  const Real closes_round_3 = u2[2] * motion.d32 - u2[0] * motion.d21;
  motion.m = min(Real(1.0), ratio(Real(motion.d21 * motion.n), motion.nu_h2));
  motion.m1 = max(Real(kLeastComplement), ratio(Real(motion.d31 * closes_round_3), motion.nu_h2));
  return motion;
}

/// Returns true if L moves in the body. It does not in a spin about a principal axis, nor if all moments
/// involved are equal.
template <class Real>
POLHODE_INLINE auto moves(const Motion<Real>& motion) {
  using std::abs;
  return (abs(motion.n) >= kNothing) & (motion.nu_h2 >= kNothing);
}

/// Returns true if the step is one substep.
template <class Real>
POLHODE_INLINE auto is_short(const Motion<Real>& motion) {
  constexpr double kLongest2 = kLongestSubstep * kLongestSubstep;
  return (motion.turn2 <= kLongest2) & (motion.nu_h2 <= kLongest2) &
         (square(motion.energy_angle) <= kLongest2);  // for an L that does not move
}

}  // namespace polhode::free_top
