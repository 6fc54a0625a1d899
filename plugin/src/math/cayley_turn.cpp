#include "math/cayley_turn.h"

#include <Eigen/LU>
#include <limits>

#include "polhode/rotation_math.h"

namespace polhode::formulas {

namespace {

// Three or four suffice for |omega| dt up to 1. Close to the end of a branch of roots, convergence is only
// linear.
constexpr int kMaximumIterations = 60;
// The line search gives up below this fraction, at a minimum of the residual.
constexpr double kSmallestFraction = 1e-9;
// Size of the last Newton step, relative to a. The remaining error is of its square, below rounding.
constexpr double kLastStep = 1e-10;
// Size of the residual relative to the right-hand side, for bodies so slender that no Newton step reaches
// kLastStep.
constexpr double kRounding = 1e-14;

// Returns I a + (dt/2) h. Without rotors nothing is added, since -0 + 0 would change the sign bit.
Vector3 m_B(const CayleyEquation& equation, const Vector3& a) {
  const Vector3 moment_B = equation.inertia_B.cwiseProduct(a);
  return equation.half_rotor_B.isZero(0.0) ? moment_B : Vector3(moment_B + equation.half_rotor_B);
}

Vector3 residual(const CayleyEquation& equation, const Vector3& a) {
  const Vector3 moment_B = m_B(equation, a);
  return moment_B + a.cross(moment_B) - (1.0 + equation.stretch * a.squaredNorm()) * equation.half_impulse_B;
}

// Returns d residual / d a = I + [a] I - [m] - 2 stretch g a^T.
Matrix3 jacobian(const CayleyEquation& equation, const Vector3& a) {
  const Vector3 moment_B = m_B(equation, a);
  Matrix3 derivative = skew(a) * equation.inertia_B.asDiagonal() - skew(moment_B) -
                       2.0 * equation.stretch * equation.half_impulse_B * a.transpose();
  derivative.diagonal() += equation.inertia_B;
  return derivative;
}

// Halves the step until the residual decreases. Returns false if no fraction decreases it, for example with
// NaN.
bool search_along(const CayleyEquation& equation, const Vector3& step, Vector3& a, Vector3& residual_at_a) {
  const double start = residual_at_a.norm();
  for (double fraction = 1.0; fraction > kSmallestFraction; fraction *= 0.5) {
    const Vector3 next = a + fraction * step;
    const Vector3 residual_at_next = residual(equation, next);
    // 1e-4: Armijo's constant for a sufficient decrease
    if (residual_at_next.norm() < (1.0 - 1e-4 * fraction) * start) {
      a = next;
      residual_at_a = residual_at_next;
      return true;
    }
  }
  return false;
}

Vector3 solve(const CayleyEquation& equation, const Vector3& first_guess) {
  Vector3 a = first_guess;
  Vector3 residual_at_a = residual(equation, a);
  for (int iteration = 0; iteration < kMaximumIterations; ++iteration) {
    const Vector3 step = -(jacobian(equation, a).inverse() * residual_at_a);
    if (step.norm() <= kLastStep * a.norm()) return a + step;
    if (!search_along(equation, step, a, residual_at_a)) {
      if (residual_at_a.norm() <= kRounding * equation.half_impulse_B.norm()) return a;
      break;
    }
  }
  return Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

Quaternion cayley_turn_B(const CayleyEquation& equation, const Vector3& inertia_B) {
  const Vector3 a =
      solve(equation, (equation.half_impulse_B - equation.half_rotor_B).cwiseQuotient(inertia_B));
  return Quaternion(1.0, a.x(), a.y(), a.z()).normalized();
}

}  // namespace polhode::formulas
