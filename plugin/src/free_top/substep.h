#pragma once

#include <array>
#include <cmath>

#include "free_top/turn_constants.h"

/// One evaluation of the closed form. Real is double or Wide.
///
/// "Advance by h" along L = (A cn, +-B sn, +-C dn)(nu t + phase | m) is the addition theorem of Jacobi's
/// functions (DLMF 22.8): a rational map whose constants are sn, cn, dn of nu h. Axes are in the order of the
/// formulas, see labels.h.
namespace polhode::free_top {

/// The constants of a substep.
template <class Real>
struct Substep {
  Triple<Real> mu;  ///< constants of the turn: e0 e_i = mu_i (L_i + L'_i)

  // Constants of the map L -> L'.
  Real cn;
  Real dn;
  Triple<Real> slope;
  // Both are 0 if L does not move.
  std::array<Real, 2> pull_12;  ///< correction to the invariant of L_1 and L_2
  std::array<Real, 2> pull_23;  ///< correction to the invariant of L_2 and L_3
};

/// Computes the constants of a substep. If L does not move, the substep is a turn about L: in the formulas
/// used, 0/0 has no effect. `length` is |L|; `split_off_about_L` is the part of the turn about L that is
/// taken separately.
template <class Real>
POLHODE_INLINE Substep<Real> make_substep(const Motion<Real>& motion, const Real& parity, const Real& length,
                                          const Real& split_off_about_L) {
  const SnSeries<Real> series(motion.m);
  const JacobiFunctions<Real> half = formulas::jacobi_functions(series, Real(0.25 * motion.nu_h2), motion.m);
  const Real psi = (motion.energy_angle - split_off_about_L) - motion.n * mean_of_dn_term(motion, series);

  Substep<Real> step;
  step.mu = turn_constants(motion, half, psi);
  const Real per_length = 1.0 / length;
  for (Real& mu : step.mu) mu /= length;

  // By duplication (DLMF 22.6.5-7), with 1 - cn and 1 - dn instead of cn and dn.
  const Real sn2 = 0.25 * motion.nu_h2 * square(half.sn_per_argument);
  const Real per_denominator = 1.0 / (1.0 - motion.m * sn2 * sn2);
  const Real sn_per_nu_h = half.sn_per_argument * half.cn * half.dn * per_denominator;
  step.cn = 1.0 - 2.0 * sn2 * square(half.dn) * per_denominator;
  step.dn = 1.0 - 2.0 * motion.m * sn2 * square(half.cn) * per_denominator;
  const Real slope = parity * sn_per_nu_h * per_length;
  step.slope = {-motion.d32 * slope * step.dn, motion.d31 * slope, -motion.d21 * slope * step.cn};
  const auto does_move = moves(motion);
  const auto pull = [&](const Real& difference, const Real& invariant) {
    return select(does_move, Real(difference / (2.0 * invariant * length * length)), Real(0.0));
  };
  step.pull_12 = {pull(motion.d31, motion.n), pull(motion.d32, motion.n)};
  step.pull_23 = {pull(motion.d21, motion.p), pull(motion.d31, motion.p)};
  return step;
}

/// Returns the factor that moves components of L back onto their invariant, to first order. `half` is 1/2
/// except for rounding, and 0 if L does not move.
template <class Real>
POLHODE_INLINE Real pull_back(const Real& half) {
  return select(half == 0.0, Real(1.0), Real(1.5 - half));
}

/// Returns L after a substep: the addition theorem, followed by a correction to the two invariants, from
/// which rounding would let the map drift.
template <class Real>
POLHODE_INLINE Triple<Real> moved(const Substep<Real>& step, const Triple<Real>& L) {
  // 1/(1 - m sn^2(nu h) sn^2(nu t + phase)), whose factors are contained in slope[0] and slope[2].
  const Real cn_dn = step.cn * step.dn;
  const Real w = cn_dn / (cn_dn - step.slope[0] * step.slope[2] * square(L[1]));
  Real L1 = w * (step.cn * L[0] + step.slope[0] * L[1] * L[2]);
  Real L2 = w * (cn_dn * L[1] + step.slope[1] * L[0] * L[2]);
  Real L3 = w * (step.dn * L[2] + step.slope[2] * L[0] * L[1]);
  const Real pull_12 = pull_back(Real(step.pull_12[0] * square(L1) + step.pull_12[1] * square(L2)));
  L1 *= pull_12;
  L2 *= pull_12;
  const Real pull_23 = pull_back(Real(step.pull_23[0] * square(L2) + step.pull_23[1] * square(L3)));
  return {L1, L2 * pull_23, L3 * pull_23};
}

/// Returns the turn of a substep: e0 e = mu (L + L'), |(e0, e)| = 1.
template <class Real>
POLHODE_INLINE Eigen::Quaternion<Real, Eigen::DontAlign> turn_of(const Substep<Real>& step,
                                                                 const Axes<Real>& axes,
                                                                 const Triple<Real>& L,
                                                                 const Triple<Real>& next) {
  using std::sqrt;
  const Triple<Real> v = {step.mu[0] * (L[0] + next[0]), step.mu[1] * (L[1] + next[1]),
                          step.mu[2] * (L[2] + next[2])};
  const Real e0 = sqrt(0.5 + sqrt(0.25 - (square(v[0]) + square(v[1]) + square(v[2]))));
  const Eigen::Matrix<Real, 3, 1> v_B = in_body(axes, v);
  return {e0, v_B[0] / e0, v_B[1] / e0, v_B[2] / e0};
}

}  // namespace polhode::free_top
