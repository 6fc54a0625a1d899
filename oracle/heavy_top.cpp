#include "oracle/heavy_top.h"

#include <cmath>
#include <stdexcept>

namespace polhode::oracle {

// Solves A cos(tilt) Omega^2 - C spin Omega + m g l = 0, where A and C are the moments about the fixed point
// (Landau & Lifshitz, section 35, problem 1). Returns the smaller root in a form that does not cancel for a
// fast top and is not 0/0 for a horizontal one.
double slow_precession(const HeavyTop& top, double tilt, double spin) {
  const double about_point = top.transverse + top.mass * top.length * top.length;
  const double axial_momentum = top.axial * spin;
  const double torque = top.mass * top.gravity * top.length;
  const double discriminant = axial_momentum * axial_momentum - 4.0 * about_point * std::cos(tilt) * torque;
  if (!(discriminant >= 0.0) || spin == 0.0) {
    throw std::invalid_argument("slow_precession: the top spins too slowly to precess steadily");
  }
  return 2.0 * torque / (axial_momentum + std::copysign(std::sqrt(discriminant), spin));
}

SteadyTop steadily_precessing(const HeavyTop& top, double tilt, double spin) {
  const double precession = slow_precession(top, tilt, spin);
  SteadyTop result;
  result.axis_W = {std::sin(tilt), 0.0, std::cos(tilt)};
  result.omega_W = precession * Vector3::UnitZ() + (spin - precession * std::cos(tilt)) * result.axis_W;
  result.velocity_W = result.omega_W.cross(top.length * result.axis_W);
  return result;
}

}  // namespace polhode::oracle
