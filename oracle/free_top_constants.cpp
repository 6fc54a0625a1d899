#include "oracle/free_top_constants.h"

#include <boost/math/special_functions/ellint_rf.hpp>

#include "oracle/theta_series.h"

namespace polhode::oracle {

namespace {

Real arithmetic_geometric_mean(Real a, Real b) {
  // Converges quadratically: once the difference is below sqrt(epsilon), the next mean is exact.
  const Real close_enough = sqrt(std::numeric_limits<Real>::epsilon());
  while (abs(a - b) > close_enough * a) {
    const Real mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
  }
  return (a + b) / 2;
}

/// Returns F(phi, k) for |phi| <= pi/2, from sin phi, cos^2 phi and 1 - k^2 sin^2 phi (DLMF 19.25.5).
Real incomplete_integral(const Real& sine, const Real& cosine_squared, const Real& delta_squared) {
  return sine * boost::math::ellint_rf(cosine_squared, delta_squared, Real(1));
}

/// Returns K for a complementary parameter 1 - k^2, which must not be 0.
Real complete_integral(const Real& complementary_parameter) {
  return kPi / (2 * arithmetic_geometric_mean(1, sqrt(complementary_parameter)));
}

/// Subtracts the nearest whole number of periods from `value` and returns that number.
Real take_off_periods(Real& value, const Real& period) {
  const Real periods = floor(value / period + Real(0.5));
  value -= periods * period;
  return periods;
}

}  // namespace

Constants::Constants(const Polhode& polhode) : nu(polhode.nu) {
  separatrix = polhode.m1 == 0;
  const bool symmetric = polhode.m == 0;
  if (!separatrix) K = complete_integral(polhode.m1);
  const Real K_complementary = symmetric ? Real(0) : complete_integral(polhode.m);  // 0: infinite
  hyperbolic = separatrix || (!symmetric && K > 2 * K_complementary);
  u0 = incomplete_integral(polhode.u0_sine, square(polhode.u0_cosine), square(polhode.u0_delta));
  lambda_rate = (polhode.L * polhode.sine / polhode.I3 + polhode.L * (1 - polhode.sine) / polhode.I1) / 2;
  if (hyperbolic) {
    set_hyperbolic(polhode, K_complementary);
  } else {
    set_circular(polhode, K_complementary);
  }
}

// Computes K' - s directly, as an incomplete integral whose amplitude is the angle between L and the plane
// 1-2.
void Constants::set_circular(const Polhode& polhode, const Real& K_complementary) {
  scale = kPi / (2 * K);
  if (polhode.m != 0) nome = exp(-kPi * K_complementary / K);
  if (polhode.cosine != 0) {
    const Real cosine_squared = square(polhode.cosine);
    p_or_psi = exp(-scale * incomplete_integral(polhode.sine, cosine_squared,
                                                cosine_squared + polhode.m * square(polhode.sine)));
  }
  lambda_rate -= nu * scale * CircularSeries<Real>(nome, p_or_psi).rate_of_argument();
}

void Constants::set_hyperbolic(const Polhode& polhode, const Real& K_complementary) {
  scale = kPi / (4 * K_complementary);
  if (!separatrix) nome = exp(-2 * scale * K);
  p_or_psi = scale * incomplete_integral(sqrt(polhode.s_sine_squared), polhode.s_cosine_squared,
                                         polhode.s_cosine_squared + polhode.m * polhode.s_sine_squared);
  lambda_per_period = -2 * p_or_psi;
  lambda_rate -= nu * scale * HyperbolicSeries<Real>(nome, p_or_psi).rate_of_argument();
}

Phases Constants::phases_at(const Real& t) const {
  Phases phases;
  phases.u = u0 + nu * t;
  phases.lambda = lambda_rate * t;
  if (!separatrix) {
    const Real periods = take_off_periods(phases.u, 2 * K);
    phases.lambda += periods * lambda_per_period;
    phases.odd_period = floor(periods / 2) * 2 != periods;
    phases.to_end = K - abs(phases.u);
  }
  take_off_periods(phases.lambda, 2 * kPi);
  return phases;
}

}  // namespace polhode::oracle
