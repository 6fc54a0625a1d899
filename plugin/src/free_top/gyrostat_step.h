#pragma once

#include "scheme_base/wide_scheme.h"

/// Free motion of a gyrostat: a rigid body with rotors inside, whose angular momentum h is constant in body
/// axes.
///
///   L_B' = L_B x omega_B,   omega_B = I_B^-1 (L_B - h),   q' = (1/2) q [0, omega_B]
///
/// The right-hand sides are quadratic, so Cauchy products give each Taylor coefficient from the lower ones:
///
///   (k + 1) L_{k+1} = sum L_i x omega_{k-i},   (k + 1) q_{k+1} = (1/2) sum q_i [0, omega_{k-i}]
///
/// Source: V. Volterra, Acta Math. 22 (1899) 201 (the gyrostat); A. Jorba, M. Zou, Experiment. Math. 14
/// (2005) 99 (the series and its step size).
namespace polhode::free_top {

/// Each substep turns by one to three radians. If a step needs more substeps, the result is not finite.
inline constexpr int kMostGyrostatSubsteps = 4000;

/// The energy of a gyrostat, kept between steps so that it does not drift by rounding. Valid as long as L_W
/// and h stay the same bit for bit. Stored in the memory of a FreeTopStep, and distinguishable from one.
struct KeptEnergy {
  Vector3 L_W;
  Vector3 rotor_B;
  double energy;  ///< of the body without its rotors, J
};

/// Takes a step of a body with rotors. L_W is the momentum after the kick. Sets the orientation only. `kept`
/// is null for a step without memory.
void turn_gyrostat(const StepInput& input, const Vector3& L_W, RotationState& state, KeptEnergy* kept);

/// @name Access to the memory of eight bodies
/// @{
KeptEnergy get_kept_energy(std::size_t lane, const WideMemoryRow* memory);
void set_kept_energy(std::size_t lane, const KeptEnergy& kept, WideMemoryRow* memory);
/// @}

}  // namespace polhode::free_top
