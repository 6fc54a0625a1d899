#pragma once

#include <array>
#include <cstdint>

#include "polhode/rotation_state.h"

namespace polhode::free_top {

/// One step of fixed length of one free motion, ready to be taken again and again. The constants are found
/// once by make_free_top_step; a step then needs neither an elliptic nor a trigonometric function.
/// Trivially copyable, so that it can be kept in a SchemeMemory.
struct FreeTopStep {
  using Triple = std::array<double, 3>;

  // What it was made for.
  Triple inertia_B;
  double dt;

  /// The body's axes in the order 1, 2, 3 of the formulas: the polhode closes round axis 3, axis 2 is the
  /// middle one. L, mu and the constants of the map are in this order.
  std::array<std::uint8_t, 3> axis;
  std::uint16_t substeps;  ///< the map is taken so often in one step; 0: L stands still in the body

  Triple L;   ///< the momentum in body axes now
  Triple mu;  ///< of the turn: e0 e_i = mu_i (L_i + L'_i)

  // Of the map L -> L' of a substep, the addition theorem.
  double cn;
  double dn;
  Triple slope;
  double denominator_slope;
  std::array<double, 2> pull_12;  ///< back to the invariant that holds L_1 and L_2
  std::array<double, 2> pull_23;  ///< back to the one that holds L_2 and L_3

  // The turn about L that is split off a long step, and all that there is if L stands still.
  double cos_about_L;
  double sin_about_L_per_length;
};

/// inertia_B: principal moments, kg m^2, each > 0. L_B: the angular momentum in body axes, kg m^2/s, not
/// zero. dt in s. Where a result is beyond double precision the step's turn is not finite.
FreeTopStep make_free_top_step(const Vector3& inertia_B, const Vector3& L_B, double dt);

/// Whether the step was made for this inertia and length, and its momentum is L_B up to rounding.
bool fits(const FreeTopStep& step, const Vector3& inertia_B, const Vector3& L_B, double dt);

/// Takes the step: returns the orientation after it. L_W is the constant momentum.
Quaternion advance(FreeTopStep& step, const Quaternion& q_WB, const Vector3& L_W);

/// step.L in body axes.
Vector3 angular_momentum_B(const FreeTopStep& step);

}  // namespace polhode::free_top
