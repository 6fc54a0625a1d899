#include "free_top/long_step.h"

#include <algorithm>
#include <cmath>

#include "math/jacobi_functions.h"
#include "math/rotation.h"

namespace polhode::free_top {

namespace {

// Returns the longest path of L over the unit sphere of the body in h.
double longest_way(const Motion<double>& motion) {
  const double B = std::sqrt(ratio(motion.n, motion.d32));
  return Vector3(motion.d32 * B * motion.C, motion.d31 * motion.A * motion.C, motion.d21 * motion.A * B)
      .norm();
}

int substeps_for(const Motion<double>& motion) {
  return static_cast<int>(
      std::ceil(std::max(longest_way(motion), std::sqrt(motion.nu_h2)) / kLongestSubstep));
}

// Returns the angle (mod 2 pi) by which the body has turned about L after a full period of L in the body, in
// addition to 2T h/|L|.
double period_angle(FreeTopStep<double> step, const Motion<double>& period, double parity, double length) {
  const int substeps = substeps_for(period);
  const Motion<double> part = period.over(1.0 / substeps);
  step.substep = make_substep(part, parity, length, part.energy_angle);
  const Vector3 L_B = angular_momentum_B(step);
  Quaternion rho_B = Quaternion::Identity();
  for (int i = 0; i < substeps; ++i) rho_B = rho_B * take_substep(step);
  return formulas::logarithm(Quaternion(rho_B.normalized())).dot(L_B) / length;
}

}  // namespace

void set_turn_about_L(FreeTopStep<double>& step, double angle, double length) {
  const auto [sine, cosine] = formulas::sine_cosine(0.5 * angle);
  step.cos_about_L = cosine;
  step.sin_about_L_per_length = sine / length;
}

// Splits off the turn by 2T h/|L| about L. The rest of the body's turn follows the motion of L in the body:
// its whole periods add to the turn about L, the remainder is taken in substeps.
void set_long_step(FreeTopStep<double>& step, const Motion<double>& motion, double parity, double length) {
  double angle_about_L = motion.energy_angle;
  Motion<double> rest = motion;
  const double nu_h = std::sqrt(motion.nu_h2);
  const double period = 4.0 * formulas::complete_elliptic_integral(motion.m1);
  if (nu_h > period) {
    const double periods = std::floor(nu_h / period);
    angle_about_L += periods * period_angle(step, motion.over(period / nu_h), parity, length);
    rest = motion.over((nu_h - periods * period) / nu_h);
  }
  const int substeps = std::max(1, substeps_for(rest));
  const Motion<double> part = rest.over(1.0 / substeps);
  step.substep = make_substep(part, parity, length, part.energy_angle);
  set_substeps(step, substeps);
  set_turn_about_L(step, angle_about_L, length);
}

Quaternion take_substep(FreeTopStep<double>& step) {
  const Triple<double> next = moved(step.substep, step.L);
  const Quaternion rho_B = turn_of(step.substep, axes_of(step), step.L, next);
  step.L = next;
  return rho_B;
}

}  // namespace polhode::free_top
