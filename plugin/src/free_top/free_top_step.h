#pragma once

#include <cmath>

#include "free_top/substep.h"
#include "polhode/rotation_state.h"

namespace polhode::free_top {

/// One step of fixed length of one free motion, ready to be taken again and again. The constants are found
/// once by make_free_top_step; a step then needs neither an elliptic nor a trigonometric function.
/// Trivially copyable, so that it can be kept in a SchemeMemory.
struct FreeTopStep {
  // A step changes L and nothing else: what it does not write need not go back to memory.

  /// Of a short step, a substep and nothing else, order_of the axes (labels.h); else kOrders more for each
  /// substep, and once more. In one number, which a step in lanes has to look at.
  double kind;
  Triple<double> L;  ///< the momentum in body axes now, in the order of the formulas
  // What it was made for.
  Triple<double> inertia_B;
  double dt;

  Substep<double> substep;

  // The turn about L that is split off a long step, and all that there is if L stands still.
  double cos_about_L;
  double sin_about_L_per_length;

  static constexpr double kOrders = 6.0;

  bool is_short() const { return kind < kOrders; }
  Axes<double> axes() const { return axes_of(kind - kOrders * std::floor(kind / kOrders)); }
  /// So many make one step; 0: it is only the turn about L.
  int substeps() const { return is_short() ? 1 : static_cast<int>(std::floor(kind / kOrders)) - 1; }
  void set_substeps(int count) { kind = order_of(axes()) + kOrders * (count + 1); }
};

/// |L|, kg m^2/s, under which a body is taken to be at rest: its square would underflow.
inline constexpr double kAtRest = 1e-140;

/// inertia_B: principal moments, kg m^2, each > 0. L_B: the angular momentum in body axes, kg m^2/s, at
/// least kAtRest. dt in s. Where a result is beyond double precision the step's turn is not finite.
FreeTopStep make_free_top_step(const Vector3& inertia_B, const Vector3& L_B, double dt);

/// Whether the step was made for this inertia and length.
inline bool is_made_for(const FreeTopStep& step, const Vector3& inertia_B, double dt) {
  return step.dt == dt && step.inertia_B[0] == inertia_B.x() && step.inertia_B[1] == inertia_B.y() &&
         step.inertia_B[2] == inertia_B.z();
}

/// is_made_for, and its momentum is L_B up to rounding.
bool fits(const FreeTopStep& step, const Vector3& inertia_B, const Vector3& L_B, double dt);

/// Takes the step: returns the orientation after it. L_W is the constant momentum.
Quaternion advance(FreeTopStep& step, const Quaternion& q_WB, const Vector3& L_W);

/// step.L in body axes.
Vector3 angular_momentum_B(const FreeTopStep& step);

}  // namespace polhode::free_top
