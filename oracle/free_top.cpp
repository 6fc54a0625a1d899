// Free rotation of a body in theta functions (Jacobi 1850; Landau and Lifshitz, section 37, for the polhode).
//
// P is a frame fixed in the body with axes along the principal axes. The polhode goes round axis 3, and I2
// lies between I1 and I3. At the start the components y of L_P have y1 >= 0, y3 > 0. In P
//   y = (A cn u, B sn u, C dn u),  u = u0 + nu t,  parameter m = k^2.
// For the orientation let q_LP = (w, x, y, z) take P to a frame whose third axis is along L. With a = w + iz,
// b = x + iy (the Cayley-Klein parameters) dq/dt = q omega/2 is
//   a' = (i omega3 a - (omega1 - i omega2) b)/2,
// and with n = y/|L|: n3 = |a|^2 - |b|^2, n1 + i n2 = 2i a* b. As functions of u both parameters have one
// zero in a period and, at the poles of n, the singularities of 1/sqrt(theta4(x | tau)). Hence
//   a = N e^(i Lambda) theta4(x - i epsilon | 2 tau)
//   b = N e^(i Lambda) theta1(x - i epsilon | 2 tau),  x = pi u/2K,
// with the nome of m, e^(i pi tau) = e^(-pi K'/K), a phase Lambda that grows at a constant rate, and a real
// common factor N, which normalising the quaternion removes. By the addition formulas for theta functions n3
// is dn u times a constant, which gives epsilon = pi s/2K with dn(i s) = |L|/C. The rate of Lambda follows
// from that of arg a at u = 0, which is (C/I3 + (|L| - C)/I1)/2.
//
// Near the separatrix, k -> 1 and K -> infinity, these series converge slowly. Jacobi's imaginary
// transformation (DLMF 20.7(viii)) gives, up to a common factor,
//   a = e^(i Lambda) theta2(psi + i w),  b = -i e^(i Lambda) theta1(psi + i w),
//   psi = pi s/4K',  w = pi u/4K',  nome e^(-pi K/2K'),
// which are series in hyperbolic functions. On the separatrix only their first terms remain, tanh and sech.
// First, u is reduced to |u| <= K; each period 2K removed subtracts 2 psi from Lambda and flips the sign of
// b.
//
// Boost's jacobi_elliptic takes k, and 1 - k^2 loses all digits near the separatrix. Here m and 1 - m are
// both computed without cancellation, and K, K', s and u0 follow from both by the arithmetic-geometric mean
// and Carlson's R_F.
#include "oracle/free_top.h"

#include <stdexcept>

#include "oracle/free_top_constants.h"
#include "oracle/theta_series.h"

namespace polhode::oracle {

namespace {

/// q_LP at given phases, in number type R. Not normalised.
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

/// Places the closed form in the world and in the body: q_WB = q_WL q_LP q_PB.
struct Placement {
  Constants constants;
  Axes axes;
  Rotation<Real> q_WL, q_PB;
};

/// q_WB, in number type R. Not normalised.
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
    // The angle is small from here on: double precision rounds only its last digit.
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

/// Computes L_B/|L| from the third row of the matrix of q_LP.
Triple<Real> direction_B(const Rotation<Real>& q_LP, const Axes& axes) {
  const Triple<Real> direction(2 * (q_LP.x() * q_LP.z() - q_LP.w() * q_LP.y()),
                               2 * (q_LP.y() * q_LP.z() + q_LP.w() * q_LP.x()),
                               square(q_LP.w()) + square(q_LP.z()) - square(q_LP.x()) - square(q_LP.y()));
  Triple<Real> result;
  for (int i = 0; i < 3; ++i) result[axes[i].index] = axes[i].sign * direction[i] / q_LP.squaredNorm();
  return result;
}

/// Computes q^-1 L q times |q|^2. Avoids the division, so that exact zeros stay exact.
Triple<Wide> unnormalised_L_B(const Quaternion& q_WB, const Vector3& L_W) {
  const Rotation<Wide> q = widened<Wide>(q_WB);
  const Rotation<Wide> L(Wide(0), Wide(L_W.x()), Wide(L_W.y()), Wide(L_W.z()));
  return (q.conjugate() * L * q).vec();
}

Constants constants_of(const Triple<Wide>& inertia_B, const Triple<Wide>& L_B, const Axes& axes,
                       const Real& q_squared) {
  Polhode polhode = polhode_of(inertia_B, L_B, axes);
  // The length of q cancels in all other constants.
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
