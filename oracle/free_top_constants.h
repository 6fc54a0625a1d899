#pragma once

#include "oracle/polhode_curve.h"

namespace polhode::oracle {

/// The position of a motion within its periods.
struct Phases {
  Real lambda;              ///< phase of a and b, reduced to |lambda| <= pi
  Real u;                   ///< reduced to |u| <= K
  Real to_end;              ///< K - |u|
  bool odd_period = false;  ///< true: the sign of b is flipped
};

/// Constants of the closed form.
struct Constants {
  explicit Constants(const Polhode& polhode);
  Phases phases_at(const Real& t) const;

  bool separatrix = false;  ///< u has no period: K is infinite
  bool hyperbolic = false;
  Real K = 0, nu = 0, u0 = 0;
  Real nome = 0;
  Real p_or_psi = 0;     ///< argument of the circular (p) or hyperbolic (psi) series
  Real scale = 0;        ///< factor from u to x or w
  Real lambda_rate = 0;  ///< rad/s
  Real lambda_per_period = 0;

 private:
  void set_circular(const Polhode& polhode, const Real& K_complementary);
  void set_hyperbolic(const Polhode& polhode, const Real& K_complementary);
};

}  // namespace polhode::oracle
