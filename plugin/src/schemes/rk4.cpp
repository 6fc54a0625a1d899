// rk4: the classical Runge-Kutta method for the orientation, at constant momentum.
//
//   rho' = f(rho) = 1/2 rho [0, omega_B],  omega_B = I_B^-1 (L_B(rho) - h),  L_B(rho) = rho^-1 L_B rho
//   k1 = f(1),  k2 = f(1 + dt k1 / 2),  k3 = f(1 + dt k2 / 2),  k4 = f(1 + dt k3)
//   rho = 1 + dt (k1 + 2 k2 + 2 k3 + k4)/6,   q_{t+1} = q_t rho/|rho|
//
// rho is the body's turn since the start of the step, L_B(rho) the momentum in body axes there, h the
// momentum of the rotors. A stage is not a unit quaternion: only rho^-1, not its conjugate, rotates the
// momentum without scaling it.
//
// Source: W. Kutta, Z. Math. Phys. 46 (1901) 435; E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary
// Differential Equations I (1993), section II.1, table 1.2.
// Order: 4 in free motion, 1 under torques. Conserves: L_W exactly; energy not; det R exactly.
// Fails when: it runs long. Energy falls by up to (|omega| dt)^6/200 a step for moments of 1 to 3, like with
// friction inside the body, until the body spins about its axis of largest moment. Slender bodies, whose
// velocity changes much with a small turn, fail sooner: with a moment ratio of 100, one step at |omega| dt =
// 0.5 may be off by 0.02.
#include "scheme_base/kick_and_turn.h"
#include "scheme_base/scheme_definition.h"

namespace polhode::schemes {

namespace {

using Coefficients = Eigen::Vector4d;  // Eigen's order: x, y, z, w

Coefficients rate(const FreeMotion& motion, const Coefficients& rho) {
  const Quaternion turn(rho);
  const Vector3& L_B = motion.L_B;
  const Vector3 turned_L_B = (turn.inverse() * Quaternion(0.0, L_B.x(), L_B.y(), L_B.z()) * turn).vec();
  const Vector3 omega_B = (turned_L_B - motion.rotor_B).cwiseQuotient(motion.inertia_B);
  return 0.5 * (turn * Quaternion(0.0, omega_B.x(), omega_B.y(), omega_B.z())).coeffs();
}

Quaternion turn_B(const FreeMotion& motion) {
  const double dt = motion.dt;
  const Coefficients start = Quaternion::Identity().coeffs();
  const Coefficients k1 = rate(motion, start);
  const Coefficients k2 = rate(motion, start + 0.5 * dt * k1);
  const Coefficients k3 = rate(motion, start + 0.5 * dt * k2);
  const Coefficients k4 = rate(motion, start + dt * k3);
  const Coefficients rho = start + dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  return Quaternion(rho).normalized();
}

}  // namespace

const RotationScheme& rk4() {
  static const KickAndTurnScheme<turn_B> scheme(
      {"rk4", "classical Runge-Kutta of the orientation at constant momentum",
       "Hairer, Norsett, Wanner 1993, section II.1",
       "it runs long: energy falls, by some (|omega| dt)^6/200 a step, until a plain spin is left", 4,
       Conservation::lost, Conservation::exact, Conservation::exact, TurnVelocity::mean, true});
  return scheme;
}

}  // namespace polhode::schemes
