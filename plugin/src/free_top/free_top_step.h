#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "free_top/substep.h"
#include "polhode/rotation_state.h"

namespace polhode::free_top {

/// One step of fixed length of one free motion, ready to be taken again and again. The constants are found
/// once by make_free_top_step; a step then needs neither an elliptic nor a trigonometric function.
/// Real is double, or Wide for the steps of eight bodies. A step with all numbers 0 is empty.
template <class Real>
struct FreeTopStep {
  /// Of a short step, which is one substep: order_of the axes (labels.h). Each substep of a long step adds
  /// kOrders, and a long step adds kOrders once more. One number, since eight bodies' are tested at once.
  Real kind;
  Triple<Real>
      L;    ///< the momentum in body axes now, in the order of the formulas; a step changes nothing else
  Real dt;  ///< the step's length

  Substep<Real> substep;

  // The turn about L that is split off a long step; the only turn if L stands still.
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

/// |L|, kg m^2/s, under which a body is taken to be at rest: its square would underflow.
inline constexpr double kAtRest = 1e-140;

template <class Real>
POLHODE_INLINE auto is_short(const FreeTopStep<Real>& step) {
  return step.kind < FreeTopStep<Real>::kOrders;
}

/// @name Of one body
/// @{
Axes<double> axes_of(const FreeTopStep<double>& step);
/// The number of substeps of one step; 0: the step is only the turn about L.
int substeps_of(const FreeTopStep<double>& step);
void set_substeps(FreeTopStep<double>& step, int count);

/// inertia_B: principal moments, kg m^2, each > 0. L_B: the angular momentum in body axes, kg m^2/s, at
/// least kAtRest. dt in s. Where a result is beyond double precision the step's turn is not finite.
FreeTopStep<double> make_free_top_step(const Vector3& inertia_B, const Vector3& L_B, double dt);

/// Returns whether the step was made for this length, and its momentum is L_B up to rounding.
bool fits(const FreeTopStep<double>& step, const Vector3& L_B, double dt);

/// Takes the step: returns the orientation after it. L_W is the constant momentum.
Quaternion advance(FreeTopStep<double>& step, const Quaternion& q_WB, const Vector3& L_W);

/// step.L in body axes.
Vector3 angular_momentum_B(const FreeTopStep<double>& step);
/// @}

}  // namespace polhode::free_top
