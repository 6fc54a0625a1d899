#pragma once

#include "math/rotation.h"

/// The effective inertia of a body that turns during a step, given to the solver for a constrained body. Real
/// is double or Wide.
///
/// The free step from (q, L) to q' is a turn by the constant velocity u = log(q' q^-1)/dt. To change u, the
/// momentum has to change by dL = M du (implicit midpoint rule; the Jacobian of the exercise's eq. 9 at half
/// a step):
///
///   M = I_mid + G,   G = (dt/2) (I_mid [u] - [L]),   I_mid = R I_B R^T at q_mid = exp(u dt/2) q
///
/// M is not symmetric. Bullet's row solvers accept M^-1 as the inverse inertia as long as G is small compared
/// with I.
namespace polhode {

template <class Real>
struct EffectiveInertia {
  formulas::Vector<Real> u_W;  ///< turn velocity, rad/s
  formulas::Matrix<Real> M_W;  ///< kg m^2
};

/// Limits of G relative to I within which the step resolves the gyroscopic motion of a constrained body. With
/// B = I^-1/2 G I^-1/2, every eigenvalue of the symmetric part of B must exceed -symmetric, and the axial
/// vector of the antisymmetric part must be shorter than `antisymmetric`.
struct ResolutionLimits {
  double symmetric;
  double antisymmetric;
};
/// Limits for solvers that accept M. With a wider symmetric limit, hinges and locked axes gain energy (beyond
/// half a radian a step, by factors of 1.6 and 1.8 at 0.5, of 1.24 and 1.25 at 0.3). A narrower limit drops
/// the gyroscopic term sooner (a floating frame with a rod of ratio 10 at 30 rad/s loses its momentum at 0.2
/// and keeps it at 0.3).
inline constexpr ResolutionLimits kResolvedWithM = {0.3, 0.8};
/// Limits for solvers that assume a symmetric matrix, which are given u and the plain inertia.
inline constexpr ResolutionLimits kResolvedWithoutM = {0.4, 0.4};

/// Antisymmetric limit for a body with rotors. It is wider, since the rotors' part of G is antisymmetric and
/// does no work. Measured with wheels inside a hinge, a gimbal and a weld: at a limit of 1.6 energy grows by
/// a factor of at most 1.34 and the weld opens by 0.01 rad, at 2.2 by 1.04 and 0.1 rad; beyond 3.2 energy
/// sometimes leaps up. A gyroscope without its gyroscopic term would fall.
inline constexpr double kResolvedWithRotors = 1.5;

/// Below this size relative to I, G is neglected: for resting, slow and spherical bodies.
inline constexpr double kNegligible = 1e-5;

/// Returns (dt/2) (I_B [u_B] - [L_B]) at q_mid, in body axes.
template <class Real>
POLHODE_INLINE formulas::Matrix<Real> gyroscopic_matrix_B(const formulas::Vector<Real>& inertia_B,
                                                          const formulas::Vector<Real>& u_B,
                                                          const formulas::Vector<Real>& L_B, const Real& dt) {
  const Real half_dt = 0.5 * dt;
  formulas::Matrix<Real> G;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    // [v] has -v_k in row i, column j, and v_j in row i, column k.
    G(i, i) = Real(0.0);
    G(i, j) = half_dt * (L_B[k] - inertia_B[i] * u_B[k]);
    G(i, k) = half_dt * (inertia_B[i] * u_B[j] - L_B[j]);
  }
  return G;
}

template <class Real>
struct EffectiveInertiaResult {
  using Mask = decltype(Real() < Real());

  EffectiveInertia<Real> effective;
  formulas::Matrix<Real> inverse_W;  ///< M^-1
  Mask is_resolved;
  Mask is_negligible;  ///< G is negligible: M is the plain inertia at the start of the step
};

/// Computes M from q_WB and L_W at the start of the step.
template <class Real>
POLHODE_INLINE EffectiveInertiaResult<Real> effective_inertia(const formulas::UnitQuaternion<Real>& q_WB,
                                                              const formulas::Vector<Real>& L_W,
                                                              const formulas::Vector<Real>& inertia_B,
                                                              const formulas::Vector<Real>& u_W,
                                                              const Real& dt, double symmetric_limit,
                                                              const Real& antisymmetric_limit) {
  using std::max, std::abs, std::sqrt;
  using Mask = typename EffectiveInertiaResult<Real>::Mask;
  using Matrix = formulas::Matrix<Real>;
  using Vector = formulas::Vector<Real>;
  const auto turn_to_mid_W = formulas::exponential(Vector(u_W * (0.5 * dt)));
  const Matrix R_mid = formulas::normalized(turn_to_mid_W * q_WB).toRotationMatrix();
  const Matrix G = gyroscopic_matrix_B<Real>(inertia_B, R_mid.transpose() * u_W, R_mid.transpose() * L_W, dt);

  // B = I^-1/2 G I^-1/2 has a zero diagonal.
  const auto scaled = [&](int i, int j) { return Real(G(i, j) / sqrt(Real(inertia_B[i] * inertia_B[j]))); };
  const Real B01 = scaled(0, 1), B10 = scaled(1, 0), B12 = scaled(1, 2), B21 = scaled(2, 1),
             B20 = scaled(2, 0), B02 = scaled(0, 2);
  const Real s01 = 0.5 * (B01 + B10), s12 = 0.5 * (B12 + B21), s20 = 0.5 * (B20 + B02);
  const Real a2 = 0.25 * ((B10 - B01) * (B10 - B01) + (B21 - B12) * (B21 - B12) + (B02 - B20) * (B02 - B20));
  // Sylvester: the symmetric part plus `symmetric` is positive definite if its leading minors are positive.
  const double s = symmetric_limit;
  const Real minor_2 = s * s - s01 * s01;
  const Real minor_3 = s * minor_2 - s * (s12 * s12 + s20 * s20) + 2.0 * s01 * s12 * s20;
  const Mask is_resolved =
      (minor_2 > Real(0.0)) & (minor_3 > Real(0.0)) & (a2 < antisymmetric_limit * antisymmetric_limit);
  const Real largest = max(max(max(Real(abs(B01)), Real(abs(B10))), max(Real(abs(B12)), Real(abs(B21)))),
                           max(Real(abs(B20)), Real(abs(B02))));
  const Mask is_negligible = largest < Real(kNegligible);

  Matrix M_B = G;
  for (int i = 0; i < 3; ++i) M_B(i, i) = inertia_B[i];
  const Matrix inverse_B = formulas::inverse_transposed(M_B).transpose();
  const Matrix R = q_WB.toRotationMatrix();
  const Matrix plain_W = R * inertia_B.asDiagonal() * R.transpose();
  const Matrix plain_inverse_W = R * inertia_B.cwiseInverse().asDiagonal() * R.transpose();
  return {{u_W, select(is_negligible, plain_W, Matrix(R_mid * M_B * R_mid.transpose()))},
          select(is_negligible, plain_inverse_W, Matrix(R_mid * inverse_B * R_mid.transpose())),
          is_resolved,
          is_negligible};
}

}  // namespace polhode
