// axis_splitting: rotates about the principal axes, one after the other.
//
//   T = (L_1 - h_1)^2/(2 I_1) + (L_2 - h_2)^2/(2 I_2) + (L_3 - h_3)^2/(2 I_3), h the momentum of the rotors;
//   the motion by the j-th term alone, for a time s, is
//   rho_j(s) = exp(s (L_j - h_j)/I_j e_j),  L_B <- rho_j^-1 L_B,  which does not change L_j
//   q_{t+1} = q_t rho_1(dt/2) rho_2(dt/2) rho_3(dt) rho_2(dt/2) rho_1(dt/2)
//
// Source: R. I. McLachlan, Phys. Rev. Lett. 71 (1993) 3043; S. Reich, Physica D 76 (1994) 375; J. Touma and
// J. Wisdom, Astron. J. 107 (1994) 1189; E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration
// (2006), section VII.5.
// Order: 2 in free motion, 1 under torques. Conserves: L_W exactly; energy boundedly; det R exactly.
// Fails when: |omega| dt is not small. Energy oscillates by at most (|omega| dt)^2/100 for moments of 1 to 3,
// and by up to fifteen times that for moments with a ratio of 100. Beyond about 2 rad a step it wanders over
// all values that |L| allows. The axes are not treated alike: even a ball does not rotate about a fixed axis
// within a step.
#include "scheme_base/kick_and_turn.h"
#include "scheme_base/scheme_definition.h"

namespace polhode::schemes {

namespace {

Quaternion turn_B(const FreeMotion& motion) {
  const double dt = motion.dt;
  Quaternion rho = Quaternion::Identity();
  Vector3 L_B = motion.L_B;
  const auto turn_about = [&](int axis, double duration) {
    const double angle = duration * (L_B[axis] - motion.rotor_B[axis]) / motion.inertia_B[axis];
    const Quaternion rho_axis = exponential(angle * Vector3::Unit(axis));
    rho = rho * rho_axis;
    L_B = rho_axis.conjugate() * L_B;
  };
  turn_about(0, 0.5 * dt);
  turn_about(1, 0.5 * dt);
  turn_about(2, dt);
  turn_about(1, 0.5 * dt);
  turn_about(0, 0.5 * dt);
  return rho;
}

}  // namespace

const RotationScheme& axis_splitting() {
  static const KickAndTurnScheme<turn_B> scheme(
      {"axis_splitting", "turns about the principal axes in turn, symmetrically",
       "McLachlan 1993, Reich 1994, Touma and Wisdom 1994",
       "|omega| dt is not small: energy swings as (|omega| dt)^2; past 2 rad a step it wanders", 2,
       Conservation::bounded, Conservation::exact, Conservation::exact, TurnVelocity::mean, true});
  return scheme;
}

}  // namespace polhode::schemes
