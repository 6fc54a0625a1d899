// moser_veselov: the discrete rigid body of Moser and Veselov.
//
//   I_1 e0 e1 = (dt/2) L_1 + (I_2 - I_3) e2 e3, and cyclically,  e0 = sqrt(1 - |e|^2)
//   q_{t+1} = q_t (e0, e)
//
// Dividing by e0^2 gives equations for a = e/e0, which Newton's method solves, starting at (dt/2) omega_B.
//
// Source: J. Moser and A. P. Veselov, Commun. Math. Phys. 139 (1991) 217; in quaternions E. Hairer and
// G. Vilmart, J. Phys. A 39 (2006) 13225.
// Order: 2 in free motion, 1 under torques. Conserves: energy, L_W, det R exactly.
// Fails when: |omega| dt is not small: a plain spin turns by asin(|omega| dt). Beyond 1, most steps have no
// solution, and those of a ball never have one. Beyond 1.3 no solution is found. The result is then not
// finite.
#include "math/cayley_turn.h"
#include "scheme_base/kick_and_turn.h"
#include "scheme_base/scheme_definition.h"

namespace polhode::schemes {

namespace {

Quaternion turn_B(const FreeMotion& motion) {
  return formulas::cayley_turn_B({motion.inertia_B, 0.5 * motion.dt * motion.L_B, Vector3::Zero(), 1.0},
                                 motion.inertia_B);
}

}  // namespace

const RotationScheme& moser_veselov() {
  static const KickAndTurnScheme<turn_B> scheme(
      {"moser_veselov", "the discrete rigid body of Moser and Veselov",
       "Moser and Veselov 1991; Hairer and Vilmart 2006",
       "|omega| dt is not small: a spin turns by asin(|omega| dt); past 1 few steps have a solution", 2,
       Conservation::exact, Conservation::exact, Conservation::exact});
  return scheme;
}

}  // namespace polhode::schemes
