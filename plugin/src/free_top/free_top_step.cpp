#include "free_top/free_top_step.h"

#include "free_top/long_step.h"
#include "free_top/momentum_match.h"

namespace polhode::free_top {

namespace {

constexpr double kOrders = FreeTopStep<double>::kOrders;

// In rad. In double precision, a longer turn is not known to a tenth of a radian, nor is the number of its
// whole periods: the remainder could take millions of substeps.
constexpr double kLongestStep = 1e15;

bool is_known(const Motion<double>& motion) {
  constexpr double kLongest2 = kLongestStep * kLongestStep;
  return motion.turn2 <= kLongest2 && motion.nu_h2 <= kLongest2;
}

}  // namespace

Axes<double> axes_of(const FreeTopStep<double>& step) {
  return axes_of(step.kind - kOrders * std::floor(step.kind / kOrders));
}

int substeps_of(const FreeTopStep<double>& step) {
  return is_short(step) ? 1 : static_cast<int>(std::floor(step.kind / kOrders)) - 1;
}

void set_substeps(FreeTopStep<double>& step, int count) {
  step.kind = order_of(axes_of(step)) + kOrders * (count + 1);
}

FreeTopStep<double> make_free_top_step(const Vector3& inertia_B, const Vector3& L_B, double dt) {
  const double length = L_B.norm();
  const auto body = labelled<double>(inertia_B, Vector3(L_B / length));
  const Motion<double> motion = motion_of(body.inertia, body.u, length * dt);

  FreeTopStep<double> step{};
  step.dt = dt;
  step.kind = order_of(body.axes);
  step.L = in_order(body.axes, L_B);
  if (is_short(motion)) {
    step.substep = make_substep(motion, body.parity, length, 0.0);
    step.cos_about_L = 1.0;
  } else if (!moves(motion) || !is_known(motion)) {
    set_substeps(step, 0);
    set_turn_about_L(step, motion.energy_angle, length);
  } else {
    set_long_step(step, motion, body.parity, length);
  }
  return step;
}

bool fits(const FreeTopStep<double>& step, const Vector3& L_B, double dt) {
  return step.dt == dt && is_same_momentum(angular_momentum_B(step), L_B);
}

Quaternion advance(FreeTopStep<double>& step, const Quaternion& q_WB, const Vector3& L_W) {
  Quaternion q = q_WB;
  if (step.sin_about_L_per_length != 0.0) {
    const Vector3 axis_W = step.sin_about_L_per_length * L_W;
    q = Quaternion(step.cos_about_L, axis_W.x(), axis_W.y(), axis_W.z()) * q;
  }
  for (int i = substeps_of(step); i > 0; --i) q = q * take_substep(step);
  return q;
}

Vector3 angular_momentum_B(const FreeTopStep<double>& step) {
  return in_body(axes_of(step), step.L);
}

}  // namespace polhode::free_top
