// The free rotation of a rigid body over a fixed step, in closed form.
//
// The momentum in body axes moves along an elliptic curve, L = (A cn, +-B sn, +-C dn)(nu t + phase | m), so
// that "advance by h" is the addition theorem of Jacobi's functions: a rational map with constants sn, cn, dn
// of nu h. The turn of the body in the step is rho = (e0, e) with e0 e_i = mu_i (L_i + L'_i), the form of the
// discrete Moser-Veselov equations, in which three constants mu_i make it exact.
//
// Everything is written in quantities without units: u = L/|L|, the angles a_i = |L| h / I_i and their
// differences, from which all else follows by sums of terms of one sign, so that nothing cancels:
//   d_ij = a_j - a_i = |L| h (I_i - I_j) / (I_i I_j)
//   n = u1^2 d31 + u2^2 d32,  p = u2^2 d21 + u3^2 d31           (the two invariants, (nu h)^2 = d32 p)
//   A^2 = n / d31,  B^2 = n / d32,  C^2 = p / d31,  m = d21 n / (d32 p)
//
// Sources: L. D. Landau, E. M. Lifshitz, Mechanics, section 37; DLMF 22.8 (addition theorems); J. Moser,
// A. P. Veselov, Commun. Math. Phys. 139 (1991) 217; R. van Zon, J. Schofield, J. Comput. Phys. 225 (2007)
// 145; E. Celledoni, F. Fasso, N. Safstrom, A. Zanna, SIAM J. Sci. Comput. 30 (2008) 2084.
#include "free_top/free_top_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "free_top/jacobi_functions.h"

namespace polhode::free_top {

namespace {

using Triple = FreeTopStep::Triple;

// A substep turns by less than this, rad: the square root in `turn_of` takes the branch below pi/2. Also the
// most that nu h may be, for the quadrature below to be at rounding.
constexpr double kLongestSubstep = 1.2;

// Under this an invariant is taken for zero: L then stands still in the body.
constexpr double kNothing = 1e-290;

// On the separatrix the period is infinite; with this complement 1 - m it is 188 / nu.
constexpr double kLeastComplement = 1e-40;

// The momenta of two states closer than this differ by rounding only.
constexpr double kSameMomentum = 1e-14;

double square(double x) {
  return x * x;
}

// A step of one motion, without units; the names are those of the formulas above.
struct Motion {
  double d21, d31, d32;
  double n, p;
  double energy_angle;  // 2 T h / |L|: by this the body turns about L, on average over all axes
  double A, B, C;
  double m, m1;  // m1 = 1 - m
  double nu_h;

  // The same motion over a part of the step.
  Motion over(double part) const {
    Motion shorter = *this;
    for (double* angle : {&shorter.d21, &shorter.d31, &shorter.d32, &shorter.n, &shorter.p,
                          &shorter.energy_angle, &shorter.nu_h}) {
      *angle *= part;
    }
    return shorter;
  }
};

struct Labels {
  std::array<std::uint8_t, 3> axis;
  double parity;  // of axis as a permutation of x, y, z
};

Labels labels_of(const Vector3& inertia_B, const Vector3& u_B) {
  std::array<std::uint8_t, 3> axis = {0, 1, 2};
  std::sort(axis.begin(), axis.end(), [&](int i, int j) { return inertia_B[i] < inertia_B[j]; });
  const double I1 = inertia_B[axis[0]], I2 = inertia_B[axis[1]], I3 = inertia_B[axis[2]];
  // u3^2 d32 < u1^2 d21: the polhode closes round the axis of the least moment instead.
  if (square(u_B[axis[2]]) * (I3 - I2) / I3 < square(u_B[axis[0]]) * (I2 - I1) / I1) {
    std::swap(axis[0], axis[2]);
  }
  const bool cyclic = (axis[0] + 1) % 3 == axis[1];
  return {axis, cyclic ? 1.0 : -1.0};
}

Triple in_order(const Labels& labels, const Vector3& v_B) {
  return {v_B[labels.axis[0]], v_B[labels.axis[1]], v_B[labels.axis[2]]};
}

double ratio(double numerator, double denominator) {
  return denominator == 0.0 ? 0.0 : numerator / denominator;
}

Motion motion_of(const Triple& inertia, const Triple& u, double length_times_h) {
  const auto difference = [&](int i, int j) {
    return length_times_h * (inertia[i] - inertia[j]) / (inertia[i] * inertia[j]);
  };
  Motion motion;
  motion.d21 = difference(1, 0);
  motion.d31 = difference(2, 0);
  motion.d32 = difference(2, 1);
  motion.n = square(u[0]) * motion.d31 + square(u[1]) * motion.d32;
  motion.p = square(u[1]) * motion.d21 + square(u[2]) * motion.d31;
  motion.energy_angle =
      length_times_h * (square(u[0]) / inertia[0] + square(u[1]) / inertia[1] + square(u[2]) / inertia[2]);
  motion.A = std::sqrt(ratio(motion.n, motion.d31));
  motion.B = std::sqrt(ratio(motion.n, motion.d32));
  motion.C = std::sqrt(ratio(motion.p, motion.d31));
  motion.nu_h = std::sqrt(motion.d32 * motion.p);
  const double d32_p = motion.d32 * motion.p;
  const double closes_round_3 = square(u[2]) * motion.d32 - square(u[0]) * motion.d21;
  motion.m = std::min(1.0, ratio(motion.d21 * motion.n, d32_p));
  motion.m1 = std::max(kLeastComplement, ratio(motion.d31 * closes_round_3, d32_p));
  return motion;
}

// A spin about a principal axis, or about any axis of a body for which all moments in question are equal.
bool stands_still(const Motion& motion) {
  return std::abs(motion.n) < kNothing || motion.d32 * motion.p < kNothing;
}

// The largest |omega| h on the polhode, rad, and the largest way of L over the unit sphere of the body in h.
double longest_turn(const Motion& motion, const Triple& inertia, double length_times_h) {
  return length_times_h *
         std::hypot(motion.A / inertia[0], std::min(1.0, motion.B) / inertia[1], motion.C / inertia[2]);
}

double longest_way(const Motion& motion) {
  return std::hypot(motion.d32 * motion.B * motion.C, motion.d31 * motion.A * motion.C,
                    motion.d21 * motion.A * motion.B);
}

// The turn about L from -h/2 to h/2, when L_2 = 0 in the middle: psi = integral of (a3 u3 + 2T h/|L|)/(1 +
// u3) d(t/h) with u3 = C dn(nu t), which is 2T h/|L| - n J, J = integral of u3/(1 + u3). The integrand is
// even; Gauss-Legendre with 10 nodes, 5 by symmetry, is at rounding for nu h <= 1.2.
double mean_of_dn_term(const Motion& motion) {
  constexpr std::array<double, 5> kNode = {0.14887433898163121088, 0.43339539412924719080,
                                           0.67940956829902440623, 0.86506336668898451073,
                                           0.97390652851717172008};
  constexpr std::array<double, 5> kWeight = {0.29552422471475287017, 0.26926671930999635509,
                                             0.21908636251598204400, 0.14945134915058059315,
                                             0.06667134430868813759};
  double sum = 0.0;
  for (std::size_t i = 0; i < kNode.size(); ++i) {
    const double u3 = motion.C * jacobi_functions(0.5 * motion.nu_h * kNode[i], motion.m).dn;
    sum += kWeight[i] * u3 / (1.0 + u3);
  }
  return sum;
}

// mu for unit momentum. The increment of the symmetric step is rho = arc(u-)^-1 (cos psi/2, e3 sin psi/2)
// arc(u+) with arc(u) the shortest rotation that takes u to axis 3, u+- = (A c0, +-B s0, C d0) and s0, c0, d0
// the functions of nu h/2; written out, with `a` = A c0, b = B s0 and u3 = C d0:
//   e0 = c (1 - b^2/(1 + u3)) - s ab/(1 + u3),   e1 = b c + a s,   e3 = s (u3 + b^2/(1 + u3)) - c ab/(1 + u3)
// mu_1 = e0 e1/(2 A c0), mu_3 = e0 e3/(2 C d0), in which A and C cancel; mu_2 = mu_1 - e0^2 d21/K =
// mu_3 + e0^2 d32/K with K = 2 c0 d0 nu h/s0, of which the smaller difference cancels least.
Triple turn_constants(const Motion& motion, const JacobiFunctions& half, double angle_about_L) {
  const double psi = angle_about_L - motion.n * mean_of_dn_term(motion);
  const double c = std::cos(0.5 * psi);
  const double s = std::sin(0.5 * psi);
  const double s0_per_nu_h = 0.5 * half.sn_per_argument;
  const double u3 = motion.C * half.dn;
  const double a = motion.A * half.cn;
  const double b_per_u3 = motion.A * motion.d31 * s0_per_nu_h / half.dn;
  const double b = b_per_u3 * u3;
  const double e0 = c - b * (b * c + a * s) / (1.0 + u3);
  const double mu_1 = 0.5 * e0 * (s + motion.d31 * s0_per_nu_h * motion.C * c / half.cn);
  const double mu_3 = 0.5 * e0 * (s + b_per_u3 * (b * s - a * c) / (1.0 + u3));
  const double e0_squared_per_K = e0 * e0 * s0_per_nu_h / (2.0 * half.cn * half.dn);
  const double mu_2 = std::abs(motion.d21) < std::abs(motion.d32) ? mu_1 - motion.d21 * e0_squared_per_K
                                                                  : mu_3 + motion.d32 * e0_squared_per_K;
  return {mu_1, mu_2, mu_3};
}

// Fills in the map and the turn of a substep, but for the part of the turn about L that is split off.
void set_constants(FreeTopStep& step, const Motion& motion, double parity, double length,
                   double split_off_about_L) {
  const JacobiFunctions half = jacobi_functions(0.5 * motion.nu_h, motion.m);
  const Triple mu = turn_constants(motion, half, motion.energy_angle - split_off_about_L);
  for (int i = 0; i < 3; ++i) step.mu[i] = mu[i] / length;

  // By duplication (DLMF 22.6.5-7), with 1 - cn and 1 - dn instead of cn and dn.
  const double sn2 = square(0.5 * motion.nu_h * half.sn_per_argument);
  const double denominator = 1.0 - motion.m * sn2 * sn2;
  const double sn_per_nu_h = half.sn_per_argument * half.cn * half.dn / denominator;
  step.cn = 1.0 - 2.0 * sn2 * square(half.dn) / denominator;
  step.dn = 1.0 - 2.0 * motion.m * sn2 * square(half.cn) / denominator;
  const double slope = parity * sn_per_nu_h / length;
  step.slope = {-motion.d32 * slope * step.dn, motion.d31 * slope, -motion.d21 * slope * step.cn};
  step.denominator_slope = motion.d21 * motion.d32 * square(slope);
  const double length2 = length * length;
  step.pull_12 = {motion.d31 / (2.0 * motion.n * length2), motion.d32 / (2.0 * motion.n * length2)};
  step.pull_23 = {motion.d21 / (2.0 * motion.p * length2), motion.d31 / (2.0 * motion.p * length2)};
}

// L after a substep: the addition theorem, then one first-order step back onto each of the two invariants,
// which the map would leave by rounding.
Triple moved(const FreeTopStep& step, const Triple& L) {
  const double w = 1.0 / (1.0 - step.denominator_slope * square(L[1]));
  double L1 = w * (step.cn * L[0] + step.slope[0] * L[1] * L[2]);
  double L2 = w * (step.cn * step.dn * L[1] + step.slope[1] * L[0] * L[2]);
  double L3 = w * (step.dn * L[2] + step.slope[2] * L[0] * L[1]);
  const double pull_12 = 1.5 - (step.pull_12[0] * square(L1) + step.pull_12[1] * square(L2));
  L1 *= pull_12;
  L2 *= pull_12;
  const double pull_23 = 1.5 - (step.pull_23[0] * square(L2) + step.pull_23[1] * square(L3));
  return {L1, L2 * pull_23, L3 * pull_23};
}

// The turn of a substep: e0 e = mu (L + L'), |(e0, e)| = 1.
Quaternion turn_of(const FreeTopStep& step, const Triple& L, const Triple& next) {
  Vector3 v_B;
  for (int i = 0; i < 3; ++i) v_B[step.axis[i]] = step.mu[i] * (L[i] + next[i]);
  const double e0 = std::sqrt(0.5 + std::sqrt(0.25 - v_B.squaredNorm()));
  return {e0, v_B.x() / e0, v_B.y() / e0, v_B.z() / e0};
}

Quaternion substep(FreeTopStep& step) {
  const Triple next = moved(step, step.L);
  const Quaternion rho_B = turn_of(step, step.L, next);
  step.L = next;
  return rho_B;
}

int substeps_of(const Motion& motion) {
  return static_cast<int>(std::ceil(std::max(longest_way(motion), motion.nu_h) / kLongestSubstep));
}

// After a full period L is back in the body, which has turned about it by this angle (mod 2 pi) beyond
// 2T h/|L|.
double period_angle(FreeTopStep step, const Motion& period, double parity, double length) {
  const int substeps = substeps_of(period);
  const Motion part = period.over(1.0 / substeps);
  set_constants(step, part, parity, length, part.energy_angle);
  const Triple L = step.L;
  Quaternion rho_B = Quaternion::Identity();
  for (int i = 0; i < substeps; ++i) rho_B = rho_B * substep(step);
  Vector3 L_B;
  for (int i = 0; i < 3; ++i) L_B[step.axis[i]] = L[i];
  return 2.0 * std::atan2(rho_B.vec().dot(L_B) / length, rho_B.w());
}

void set_turn_about_L(FreeTopStep& step, double angle, double length) {
  step.cos_about_L = std::cos(0.5 * angle);
  step.sin_about_L_per_length = std::sin(0.5 * angle) / length;
}

// A step of several radians. The turn by 2T h/|L| about L is split off, which leaves of the body's turn what
// L moves in the body; whole periods of that only add to the turn about L; the rest is taken in substeps.
void set_long_step(FreeTopStep& step, const Motion& motion, double parity, double length) {
  double angle_about_L = motion.energy_angle;
  Motion rest = motion;
  const double period = 4.0 * complete_elliptic_integral(motion.m1);
  if (motion.nu_h > period) {
    const double periods = std::floor(motion.nu_h / period);
    angle_about_L += periods * period_angle(step, motion.over(period / motion.nu_h), parity, length);
    rest = motion.over((motion.nu_h - periods * period) / motion.nu_h);
  }
  const int substeps = std::max(1, substeps_of(rest));
  const Motion part = rest.over(1.0 / substeps);
  set_constants(step, part, parity, length, part.energy_angle);
  step.substeps = static_cast<std::uint16_t>(substeps);
  set_turn_about_L(step, angle_about_L, length);
}

}  // namespace

FreeTopStep make_free_top_step(const Vector3& inertia_B, const Vector3& L_B, double dt) {
  const double length = L_B.norm();
  const Vector3 u_B = L_B / length;
  const Labels labels = labels_of(inertia_B, u_B);
  const Triple inertia = in_order(labels, inertia_B);
  const Motion motion = motion_of(inertia, in_order(labels, u_B), length * dt);

  FreeTopStep step{};
  step.inertia_B = {inertia_B.x(), inertia_B.y(), inertia_B.z()};
  step.dt = dt;
  step.axis = labels.axis;
  step.L = in_order(labels, L_B);
  const double turn = longest_turn(motion, inertia, length * dt);
  if (stands_still(motion) || !std::isfinite(turn + motion.nu_h)) {
    set_turn_about_L(step, motion.energy_angle, length);
  } else if (std::max(turn, motion.nu_h) <= kLongestSubstep) {
    set_constants(step, motion, labels.parity, length, 0.0);
    step.substeps = 1;
    step.cos_about_L = 1.0;
  } else {
    set_long_step(step, motion, labels.parity, length);
  }
  return step;
}

bool fits(const FreeTopStep& step, const Vector3& inertia_B, const Vector3& L_B, double dt) {
  return step.dt == dt && step.inertia_B[0] == inertia_B.x() && step.inertia_B[1] == inertia_B.y() &&
         step.inertia_B[2] == inertia_B.z() &&
         (angular_momentum_B(step) - L_B).squaredNorm() <= square(kSameMomentum) * L_B.squaredNorm();
}

Quaternion advance(FreeTopStep& step, const Quaternion& q_WB, const Vector3& L_W) {
  Quaternion q = q_WB;
  if (step.sin_about_L_per_length != 0.0) {
    const Vector3 axis_W = step.sin_about_L_per_length * L_W;
    q = Quaternion(step.cos_about_L, axis_W.x(), axis_W.y(), axis_W.z()) * q;
  }
  for (int i = 0; i < step.substeps; ++i) q = q * substep(step);
  return q;
}

Vector3 angular_momentum_B(const FreeTopStep& step) {
  Vector3 L_B;
  for (int i = 0; i < 3; ++i) L_B[step.axis[i]] = step.L[i];
  return L_B;
}

}  // namespace polhode::free_top
