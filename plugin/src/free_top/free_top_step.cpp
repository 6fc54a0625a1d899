#include "free_top/free_top_step.h"

#include "free_top/long_step.h"
#include "free_top/momentum_match.h"

namespace polhode::free_top {

FreeTopStep make_free_top_step(const Vector3& inertia_B, const Vector3& L_B, double dt) {
  const double length = L_B.norm();
  const auto body = labelled<double>(inertia_B, Vector3(L_B / length));
  const Motion<double> motion = motion_of(body.inertia, body.u, length * dt);

  FreeTopStep step{};
  step.inertia_B = {inertia_B.x(), inertia_B.y(), inertia_B.z()};
  step.dt = dt;
  step.kind = order_of(body.axes);
  step.L = in_order(body.axes, L_B);
  if (is_short(motion)) {
    step.substep = make_substep(motion, body.parity, length, 0.0);
    step.cos_about_L = 1.0;
  } else if (!moves(motion) || !std::isfinite(motion.turn2 + motion.nu_h2)) {
    step.set_substeps(0);
    set_turn_about_L(step, motion.energy_angle, length);
  } else {
    set_long_step(step, motion, body.parity, length);
  }
  return step;
}

bool fits(const FreeTopStep& step, const Vector3& inertia_B, const Vector3& L_B, double dt) {
  return is_made_for(step, inertia_B, dt) && is_same_momentum(angular_momentum_B(step), L_B);
}

Quaternion advance(FreeTopStep& step, const Quaternion& q_WB, const Vector3& L_W) {
  Quaternion q = q_WB;
  if (step.sin_about_L_per_length != 0.0) {
    const Vector3 axis_W = step.sin_about_L_per_length * L_W;
    q = Quaternion(step.cos_about_L, axis_W.x(), axis_W.y(), axis_W.z()) * q;
  }
  for (int i = step.substeps(); i > 0; --i) q = q * take_substep(step);
  return q;
}

Vector3 angular_momentum_B(const FreeTopStep& step) {
  return in_body(step.axes(), step.L);
}

}  // namespace polhode::free_top
