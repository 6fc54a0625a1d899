#pragma once

#include "scheme_base/wide_scheme.h"

/// Free motion of a gyrostat: a rigid body with rotors inside, whose angular momentum h in body axes is constant.
///
///   L_B' = L_B x omega_B,   omega_B = I_B^-1 (L_B - h),   q' = (1/2) q [0, omega_B]
///
/// The right-hand sides are quadratic, so the Taylor coefficients follow from one another by Cauchy products:
///
///   (k + 1) L_{k+1} = sum L_i x omega_{k-i},   (k + 1) q_{k+1} = (1/2) sum q_i [0, omega_{k-i}]
///
/// Source: V. Volterra, Acta Math. 22 (1899) 201 (the gyrostat); A. Jorba, M. Zou, Experiment. Math. 14 (2005) 99 (the
/// series, and how far it reaches).
namespace polhode::free_top {

/// Each turns by one to three radians. A step that needs more is not taken: the result is not finite.
inline constexpr int kMostGyrostatSubsteps = 4000;

/// What is kept of a gyrostat between two steps, so that its energy does not wander by rounding: good as long as L_W
/// and h are the same to the bit. Lies where a FreeTopStep would, and cannot be taken for one.
struct KeptEnergy {
  Vector3 L_W;
  Vector3 rotor_B;
  double energy;  ///< J; of the body without its rotors
};

/// One step of a body with rotors. L_W: after the kick. Sets the orientation, nothing else. kept: null to remember
/// nothing.
void turn_gyrostat(const StepInput& input, const Vector3& L_W, RotationState& state, KeptEnergy* kept);

/// @name In the memory of eight bodies
/// @{
KeptEnergy get_kept_energy(std::size_t lane, const WideMemoryRow* memory);
void set_kept_energy(std::size_t lane, const KeptEnergy& kept, WideMemoryRow* memory);
/// @}

}  // namespace polhode::free_top
