// A body's free rotation by theta functions (Jacobi 1850; Landau and Lifshitz, section 37, for the polhode).
//
// P is a frame fixed in the body with axes along the principal ones, axis 3 being the one that the polhode
// goes round, I2 between I1 and I3, and at the start y1 >= 0, y3 > 0 for the components y of L_P. In P
//   y = (A cn u, B sn u, C dn u),  u = u0 + nu t,  parameter m = k^2.
// For the orientation let q_LP = (w, x, y, z) take P to a frame whose third axis is along L. With
// a = w + iz, b = x + iy (the Cayley-Klein parameters) dq/dt = q omega/2 is
//   a' = (i omega3 a - (omega1 - i omega2) b)/2,
// and where n = y/|L|: n3 = |a|^2 - |b|^2, n1 + i n2 = 2i a* b. As functions of u both parameters have one
// zero in a period and, at the poles of n, the singularities of 1/sqrt(theta4(x | tau)). Hence
//   a = N e^(i Lambda) theta4(x - i epsilon | 2 tau)
//   b = N e^(i Lambda) theta1(x - i epsilon | 2 tau),  x = pi u/2K,
// with the nome of m, e^(i pi tau) = e^(-pi K'/K), a phase Lambda that grows at a constant rate, and a real
// factor N, common to both, which normalising the quaternion takes care of. By the addition formulas for
// theta functions n3 is dn u times a constant, which gives epsilon = pi s/2K with dn(i s) = |L|/C. The rate
// of Lambda follows from that of arg a at u = 0, which is (C/I3 + (|L| - C)/I1)/2.
//
// Near the separatrix, k -> 1 and K -> infinity, these series converge slowly. There Jacobi's imaginary
// transformation helps (DLMF 20.7(viii)): up to a common factor
//   a = e^(i Lambda) theta2(psi + i w),  b = -i e^(i Lambda) theta1(psi + i w),
//   psi = pi s/4K',  w = pi u/4K',  nome e^(-pi K/2K'),
// series in hyperbolic functions, of which the first terms remain on the separatrix: tanh and sech. Before
// that u is reduced to |u| <= K; each period 2K takes 2 psi from Lambda and the sign from b.
//
// Boost's jacobi_elliptic is no help here: it takes k, and 1 - k^2 is lost where the bodies get interesting.
// So m and 1 - m are both formed from what they depend on, and K, K', s and u0 from both by the
// arithmetic-geometric mean and Carlson's R_F, without a difference that could cancel.
#include "support/oracle/free_top.h"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <stdexcept>
#include <vector>

namespace polhode::oracle {

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
// Wide enough for products of the given doubles to be exact: what is zero exactly, such as the distance from
// the separatrix, must come out as zero.
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200>>;

template <class R>
using Triple = Eigen::Matrix<R, 3, 1>;
template <class R>
using Rotation = Eigen::Quaternion<R, Eigen::DontAlign>;

const Real kPi = boost::math::constants::pi<Real>();

template <class R>
R square(const R& value) {
  return value * value;
}

template <class R>
Rotation<R> widened(const Quaternion& q) {
  return {R(q.w()), R(q.x()), R(q.y()), R(q.z())};
}

template <class To, class From>
Rotation<To> converted(const Rotation<From>& q) {
  return {static_cast<To>(q.w()), static_cast<To>(q.x()), static_cast<To>(q.y()), static_cast<To>(q.z())};
}

template <class To, class From>
Triple<To> converted(const Triple<From>& v) {
  return {static_cast<To>(v.x()), static_cast<To>(v.y()), static_cast<To>(v.z())};
}

Real arithmetic_geometric_mean(Real a, Real b) {
  // Converges quadratically: a difference under the root of epsilon is the last.
  const Real close_enough = sqrt(std::numeric_limits<Real>::epsilon());
  while (abs(a - b) > close_enough * a) {
    const Real mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
  }
  return (a + b) / 2;
}

/// F(phi, k) for |phi| <= pi/2, from sin phi, cos^2 phi and 1 - k^2 sin^2 phi (DLMF 19.25.5).
Real incomplete_integral(const Real& sine, const Real& cosine_squared, const Real& delta_squared) {
  return sine * boost::math::ellint_rf(cosine_squared, delta_squared, Real(1));
}

struct Axis {
  int index = 0;
  int sign = 1;
};

/// Which of B's axes are those of P.
using Axes = std::array<Axis, 3>;

Rotation<Real> rotation_of(const Axes& axes) {
  Eigen::Matrix<Real, 3, 3> R_BP = Eigen::Matrix<Real, 3, 3>::Zero();
  for (int i = 0; i < 3; ++i) R_BP(axes[i].index, i) = axes[i].sign;
  return Rotation<Real>(R_BP).normalized();
}

/// At rest, or turning about one principal axis for ever.
bool is_steady(const Triple<Wide>& L_B) {
  return std::count(L_B.begin(), L_B.end(), Wide(0)) >= 2;
}

void make_right_handed(Axes& axes, const Triple<Wide>& L_B) {
  for (Axis* axis : {&axes[0], &axes[2]}) axis->sign = L_B[axis->index] < 0 ? -1 : 1;
  const bool cyclic = (axes[1].index - axes[0].index + 3) % 3 == 1;
  axes[1].sign = (cyclic ? 1 : -1) * axes[0].sign * axes[2].sign;
}

/// |L|^2 - 2 T I2 times |I1 - I3|, up to a positive factor: above 0 if the polhode goes round axis 3, below
/// if round axis 1, 0 on the separatrix. No quotient and no root is rounded here.
Wide side_of_separatrix(const Triple<Wide>& inertia, const Triple<Wide>& L) {
  return square(L[2]) * abs(inertia[2] - inertia[1]) * inertia[0] -
         square(L[0]) * abs(inertia[1] - inertia[0]) * inertia[2];
}

/// Components along P's axes, but for their signs.
Triple<Wide> ordered(const Triple<Wide>& v_B, const Axes& axes) {
  return {v_B[axes[0].index], v_B[axes[1].index], v_B[axes[2].index]};
}

Axes polhode_axes(const Triple<Wide>& inertia_B, const Triple<Wide>& L_B) {
  Axes axes{{{0}, {1}, {2}}};
  std::sort(axes.begin(), axes.end(),
            [&](const Axis& a, const Axis& b) { return inertia_B[a.index] < inertia_B[b.index]; });
  if (is_steady(L_B)) {
    const auto spun =
        std::find_if(axes.begin(), axes.end(), [&](const Axis& a) { return L_B[a.index] != 0; });
    if (spun != axes.end()) std::swap(*spun, axes[2]);
  } else {
    const Triple<Wide> inertia = ordered(inertia_B, axes);
    // A symmetric top's polhode goes round its own axis.
    if (side_of_separatrix(inertia, ordered(L_B, axes)) < 0 || inertia[2] == inertia[1]) {
      std::swap(axes[0], axes[2]);
    }
  }
  make_right_handed(axes, L_B);
  return axes;
}

/// The polhode's constants.
struct Polhode {
  Real I1, I3;              ///< moments, in the order of P's axes
  Real L;                   ///< |L|
  Real sine, cosine;        ///< C/|L| and A/|L|, of the angle between L and the plane 1-2 where u = 0
  Real m = 0, m1 = 1;       ///< the parameter k^2, and 1 - k^2
  Real nu = 0;              ///< du/dt
  Real u0_sine = 0;         ///< sn u0
  Real u0_cosine = 1;       ///< cn u0, not below 0
  Real u0_delta = 1;        ///< dn u0
  Real s_sine_squared = 0;  ///< of the amplitude of s
  Real s_cosine_squared = 1;
};

Polhode steady_polhode(const Real& inertia, const Real& L) {
  Polhode polhode;
  polhode.I1 = polhode.I3 = inertia;
  polhode.L = L;
  polhode.sine = 1;
  polhode.cosine = 0;
  return polhode;
}

/// y = L_P; the moments in the order of P's axes. Not for a steady motion.
Polhode polhode_through(const Triple<Wide>& inertia, const Triple<Wide>& y) {
  const Wide &I1 = inertia[0], &I2 = inertia[1], &I3 = inertia[2];
  const Wide d21 = abs(I2 - I1), d32 = abs(I3 - I2), d31 = abs(I3 - I1);
  // Relative to d31. In a sphere any axis is as good as another.
  const Wide part32 = d31 == 0 ? Wide(1) : Wide(d32 / d31), part21 = d31 == 0 ? Wide(0) : Wide(d21 / d31);
  const Wide A_squared = square(y[0]) + square(y[1]) * I1 * part32 / I2;
  const Wide C_squared = square(y[2]) + square(y[1]) * I3 * part21 / I2;
  const Wide B_squared = A_squared * I2 / (I1 * part32);
  const Wide L_squared = y.squaredNorm();
  Polhode polhode;
  polhode.I1 = Real(I1);
  polhode.I3 = Real(I3);
  polhode.L = Real(sqrt(L_squared));
  polhode.sine = Real(sqrt(C_squared / L_squared));
  polhode.cosine = Real(sqrt(A_squared / L_squared));
  if (d21 != 0) {
    polhode.m = Real(d21 * I3 * A_squared / (d32 * I1 * C_squared));
    polhode.m1 = Real(side_of_separatrix(inertia, y) / (d32 * I1 * C_squared));
    polhode.u0_delta = Real(y[2] / sqrt(C_squared));
  }
  polhode.nu = Real(sqrt(C_squared * d32 * d31 / (I1 * I2)) / I3) * (I3 > I1 ? 1 : -1);
  polhode.u0_sine = Real(y[1] / sqrt(B_squared));
  polhode.u0_cosine = Real(y[0] / sqrt(A_squared));
  if (d31 != 0) {
    polhode.s_sine_squared = Real(I1 * d32 / (I2 * d31));
    polhode.s_cosine_squared = Real(I3 * d21 / (I2 * d31));
  }
  return polhode;
}

/// K of the modulus with this complementary parameter, not 0.
Real complete_integral(const Real& complementary_parameter) {
  return kPi / (2 * arithmetic_geometric_mean(1, sqrt(complementary_parameter)));
}

/// Terms below this, relative to the largest, are left out.
template <class R>
Real negligible() {
  return Real(std::numeric_limits<R>::epsilon()) / 16;
}

/// a and b before their phase, up to a common factor, where the series in cosines converges fast. With
/// p = e^(epsilon - pi K'/2K) and x = pi u/2K, theta4 has the even and theta1 the odd of the terms
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
    R cosine = 1, sine = 0;  // of k x
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

/// The same near the separatrix, of zeta' = psi + i w with w = pi u/4K', |u| <= K: theta2 and theta1 have
/// terms nome^(n^2 + n) e^(+-(2n + 1)(w - i psi)), here divided by e^|w|, which may be beyond any number.
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

  /// `decay` is e^-|w|; `growth` is nome e^2|w|, which is 1 where the period ends.
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

/// Where in its periods a motion is.
struct Phases {
  Real lambda;              ///< of a and b, reduced to |lambda| <= pi
  Real u;                   ///< reduced to |u| <= K
  Real to_end;              ///< K - |u|
  bool odd_period = false;  ///< b has the other sign
};

/// The quotient rounded to a whole number, which is what is taken off.
Real take_off_periods(Real& value, const Real& period) {
  const Real periods = floor(value / period + Real(0.5));
  value -= periods * period;
  return periods;
}

/// The closed form's constants.
struct Constants {
  explicit Constants(const Polhode& polhode);
  Phases phases_at(const Real& t) const;

  bool separatrix = false;  ///< u has no period: K is infinite
  bool hyperbolic = false;
  Real K = 0, nu = 0, u0 = 0;
  Real nome = 0;
  Real p_or_psi = 0;     ///< what the circular, the hyperbolic series has
  Real scale = 0;        ///< from u to x or w
  Real lambda_rate = 0;  ///< rad/s
  Real lambda_per_period = 0;

 private:
  void set_circular(const Polhode& polhode, const Real& K_complementary);
  void set_hyperbolic(const Polhode& polhode, const Real& K_complementary);
};

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

// K' - s is an integral of its own, whose amplitude is the angle between L and the plane 1-2.
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

/// q_LP at the phases, in one type of numbers. Not a unit quaternion.
template <class R>
class PeriodicPart {
 public:
  explicit PeriodicPart(const Constants& constants)
      : hyperbolic_(constants.hyperbolic), separatrix_(constants.separatrix), scale_(constants.scale) {
    if (hyperbolic_) {
      hyperbolic_series_ = HyperbolicSeries<R>(constants.nome, constants.p_or_psi);
    } else {
      circular_series_ = CircularSeries<R>(constants.nome, constants.p_or_psi);
    }
  }

  Rotation<R> q_LP(const Phases& phases) const {
    using std::cos, std::sin;
    Rotation<R> q = series_at(phases);
    if (phases.odd_period) {
      q.x() = -q.x();
      q.y() = -q.y();
    }
    const R lambda = static_cast<R>(phases.lambda);
    return Rotation<R>(cos(lambda), R(0), R(0), sin(lambda)) * q;
  }

 private:
  Rotation<R> series_at(const Phases& phases) const {
    using std::abs, std::exp;
    const R scaled = scale_ * static_cast<R>(phases.u);
    if (!hyperbolic_) return circular_series_.at(scaled);
    const R growth = separatrix_ ? R(0) : R(exp(-2 * scale_ * static_cast<R>(phases.to_end)));
    return hyperbolic_series_.at(exp(-abs(scaled)), growth, phases.u < 0);
  }

  bool hyperbolic_, separatrix_;
  R scale_;
  CircularSeries<R> circular_series_;
  HyperbolicSeries<R> hyperbolic_series_;
};

/// How the closed form lies in the world and in the body: q_WB = q_WL q_LP q_PB.
struct Placement {
  Constants constants;
  Axes axes;
  Rotation<Real> q_WL, q_PB;
};

/// q_WB, in one type of numbers. Not a unit quaternion.
template <class R>
class Orientation {
 public:
  explicit Orientation(const Placement& placement)
      : periodic_part_(placement.constants),
        q_WL_(converted<R>(placement.q_WL)),
        q_PB_(converted<R>(placement.q_PB)) {}

  Rotation<R> q_LP(const Phases& phases) const { return periodic_part_.q_LP(phases); }
  Rotation<R> at(const Phases& phases) const { return q_WL_ * q_LP(phases) * q_PB_; }

  double error_of(const Quaternion& q_WB, const Phases& phases) const {
    using std::sqrt;
    const Rotation<R> difference = at(phases).conjugate() * widened<R>(q_WB);
    const R sine = sqrt(difference.vec().squaredNorm());
    // From here on a rounding is one of the angle's last digit.
    return 2 * std::atan2(static_cast<double>(sine), std::abs(static_cast<double>(difference.w())));
  }

 private:
  PeriodicPart<R> periodic_part_;
  Rotation<R> q_WL_, q_PB_;
};

void check(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& L_W) {
  if (!inertia_B.allFinite() || !(inertia_B.minCoeff() > 0.0)) {
    throw std::invalid_argument("FreeTop: moments of inertia must be finite and above 0");
  }
  if (!q_WB.coeffs().allFinite() || q_WB.coeffs().isZero(0.0)) {
    throw std::invalid_argument("FreeTop: an orientation must be finite and not 0");
  }
  if (!L_W.allFinite()) throw std::invalid_argument("FreeTop: the angular momentum must be finite");
}

/// L_B/|L| from the third row of q_LP's matrix.
Triple<Real> direction_B(const Rotation<Real>& q_LP, const Axes& axes) {
  const Triple<Real> direction(2 * (q_LP.x() * q_LP.z() - q_LP.w() * q_LP.y()),
                               2 * (q_LP.y() * q_LP.z() + q_LP.w() * q_LP.x()),
                               square(q_LP.w()) + square(q_LP.z()) - square(q_LP.x()) - square(q_LP.y()));
  Triple<Real> result;
  for (int i = 0; i < 3; ++i) result[axes[i].index] = axes[i].sign * direction[i] / q_LP.squaredNorm();
  return result;
}

/// q^-1 L q times |q|^2: without a division, so that what is 0 is.
Triple<Wide> unnormalised_L_B(const Quaternion& q_WB, const Vector3& L_W) {
  const Rotation<Wide> q = widened<Wide>(q_WB);
  const Rotation<Wide> L(Wide(0), Wide(L_W.x()), Wide(L_W.y()), Wide(L_W.z()));
  return (q.conjugate() * L * q).vec();
}

Polhode polhode_of(const Triple<Wide>& inertia_B, const Triple<Wide>& L_B, const Axes& axes) {
  if (is_steady(L_B)) return steady_polhode(Real(inertia_B[axes[2].index]), Real(L_B.norm()));
  Triple<Wide> L_P = ordered(L_B, axes);
  for (int i = 0; i < 3; ++i) L_P[i] *= axes[i].sign;
  return polhode_through(ordered(inertia_B, axes), L_P);
}

Constants constants_of(const Triple<Wide>& inertia_B, const Triple<Wide>& L_B, const Axes& axes,
                       const Real& q_squared) {
  Polhode polhode = polhode_of(inertia_B, L_B, axes);
  // All else is a quotient in which the length of q cancels.
  polhode.L /= q_squared;
  polhode.nu /= q_squared;
  return Constants(polhode);
}

Placement placement_of(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& L_W) {
  check(inertia_B, q_WB, L_W);
  const Triple<Wide> moments_B(inertia_B.x(), inertia_B.y(), inertia_B.z());
  const Triple<Wide> L_B = unnormalised_L_B(q_WB, L_W);
  const Axes axes = polhode_axes(moments_B, L_B);
  const Rotation<Real> start_q_WB = widened<Real>(q_WB);
  const Constants constants = constants_of(moments_B, L_B, axes, start_q_WB.squaredNorm());
  const Rotation<Real> q_LP = PeriodicPart<Real>(constants).q_LP(constants.phases_at(0)).normalized();
  const Rotation<Real> q_BP = rotation_of(axes);
  return {constants, axes, start_q_WB.normalized() * q_BP * q_LP.conjugate(), q_BP.conjugate()};
}

}  // namespace

struct FreeTop::Motion {
  Motion(const Vector3& moments_B, const Quaternion& start_q_WB, const Vector3& momentum_W)
      : inertia_B(moments_B),
        L_W(momentum_W),
        placement(placement_of(inertia_B, start_q_WB, L_W)),
        exact(placement),
        quick(placement) {}

  Phases phases_at(const Real& t) const { return placement.constants.phases_at(t); }
  Rotation<Real> q_WB(double t_s) const { return exact.at(phases_at(t_s)).normalized(); }
  Triple<Real> L_B(double t_s) const {
    const Triple<Real> L(L_W.x(), L_W.y(), L_W.z());
    return direction_B(exact.q_LP(phases_at(t_s)), placement.axes) * Real(sqrt(L.squaredNorm()));
  }

  Vector3 inertia_B, L_W;
  Placement placement;
  Orientation<Real> exact;
  Orientation<long double> quick;
};

FreeTop::FreeTop(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& L_W)
    : motion_(std::make_unique<Motion>(inertia_B, q_WB, L_W)) {}

FreeTop::~FreeTop() = default;
FreeTop::FreeTop(FreeTop&&) noexcept = default;
FreeTop& FreeTop::operator=(FreeTop&&) noexcept = default;

Quaternion FreeTop::q_WB(double t_s) const {
  return converted<double>(motion_->q_WB(t_s));
}

Vector3 FreeTop::L_B(double t_s) const {
  return converted<double>(motion_->L_B(t_s));
}

RotationState FreeTop::at(double t_s) const {
  const Rotation<Real> q_WB = motion_->q_WB(t_s);
  Triple<Real> omega_B = motion_->L_B(t_s);
  for (int axis = 0; axis < 3; ++axis) omega_B[axis] /= motion_->inertia_B[axis];
  RotationState state;
  state.q_WB = converted<double>(q_WB);
  const Eigen::Matrix<Real, 3, 3> R_WB = q_WB.toRotationMatrix();
  for (int i = 0; i < 9; ++i) state.R_WB(i) = static_cast<double>(R_WB(i));
  state.omega_W = converted<double>(Triple<Real>(R_WB * omega_B));
  state.L_W = motion_->L_W;
  return state;
}

double FreeTop::attitude_error(const Quaternion& q_WB, double t_s) const {
  return motion_->exact.error_of(q_WB, motion_->phases_at(t_s));
}

double FreeTop::attitude_error_after(const Quaternion& q_WB, std::int64_t steps, double dt_s) const {
  return motion_->quick.error_of(q_WB, motion_->phases_at(Real(steps) * dt_s));
}

}  // namespace polhode::oracle
