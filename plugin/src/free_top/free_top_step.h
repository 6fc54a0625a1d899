#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "free_top/substep.h"
#include "polhode/rotation_state.h"

namespace polhode::free_top {

/// A step of fixed length of a free motion, prepared so that it can be taken repeatedly. make_free_top_step
/// computes the constants once; a step then needs neither elliptic nor trigonometric functions. Real is
/// double, or Wide for the steps of eight bodies. A step in which all numbers are 0 is empty.
template <class Real>
struct FreeTopStep {
  /// For a short step, which is one substep: order_of the axes (labels.h). Each substep of a long step adds
  /// kOrders, and a long step adds kOrders once more. Kept in one number, so that eight bodies can be tested
  /// at once.
  Real kind;
  Triple<Real> L;  ///< present momentum in body axes, in the order of the formulas; changes in a step
  Real dt;         ///< length of the step

  Substep<Real> substep;

  // The turn about L that is split off from a long step; the only turn if L does not move in the body.
  Real cos_about_L;
  Real sin_about_L_per_length;

  static constexpr double kOrders = 6.0;
  static constexpr std::size_t kNumbers = 19;

  /// Calls function(number, i) for each of the kNumbers numbers.
  template <class Self, class Function>
  static POLHODE_INLINE void for_each_number(Self& step, Function function) {
    std::size_t i = 0;
    function(step.kind, i++);
    for (auto& number : step.L) function(number, i++);
    function(step.dt, i++);
    for (auto& number : step.substep.mu) function(number, i++);
    function(step.substep.cn, i++);
    function(step.substep.dn, i++);
    for (auto& number : step.substep.slope) function(number, i++);
    for (auto& number : step.substep.pull_12) function(number, i++);
    for (auto& number : step.substep.pull_23) function(number, i++);
    function(step.cos_about_L, i++);
    function(step.sin_about_L_per_length, i++);
  }
};
static_assert(sizeof(FreeTopStep<double>) == FreeTopStep<double>::kNumbers * sizeof(double));

/// |L|, kg m^2/s, below which a body counts as at rest: its square would underflow.
inline constexpr double kAtRest = 1e-140;

template <class Real>
POLHODE_INLINE auto is_short(const FreeTopStep<Real>& step) {
  return step.kind < FreeTopStep<Real>::kOrders;
}

/// @name Functions for one body
/// @{
Axes<double> axes_of(const FreeTopStep<double>& step);
/// Returns the number of substeps of one step. With 0 substeps, the step is only the turn about L.
int substeps_of(const FreeTopStep<double>& step);
void set_substeps(FreeTopStep<double>& step, int count);

/// Prepares a step. inertia_B: principal moments, kg m^2, each > 0. L_B: angular momentum in body axes,
/// kg m^2/s, at least kAtRest. dt: s. If a result exceeds double precision, the turn of the step is not
/// finite.
FreeTopStep<double> make_free_top_step(const Vector3& inertia_B, const Vector3& L_B, double dt);

/// Returns true if the step was prepared for this dt and its momentum is L_B up to rounding.
bool fits(const FreeTopStep<double>& step, const Vector3& L_B, double dt);

/// Takes the step and returns the orientation at its end. L_W is the constant momentum.
Quaternion advance(FreeTopStep<double>& step, const Quaternion& q_WB, const Vector3& L_W);

/// Returns step.L in body axes.
Vector3 angular_momentum_B(const FreeTopStep<double>& step);
/// @}

}  // namespace polhode::free_top
