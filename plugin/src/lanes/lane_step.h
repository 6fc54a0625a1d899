#pragma once

#include "lanes/lanes.h"
#include "polhode/rotation_scheme.h"
#include "rotation_formulas.h"

/// StepInput and RotationState of eight bodies, and what rotation_math.h has for the latter.
namespace polhode {

struct LaneInput {
  Vector3L inertia_B;
  Vector3L delta_omega_W;
  Lanes dt;
  Lanes turn_dt;
};

struct LaneState {
  QuaternionL q_WB;
  Matrix3L R_WB;
  Vector3L omega_W;
  Vector3L L_W;
};

inline void set_orientation(LaneState& state, const QuaternionL& q_WB) {
  state.q_WB = q_WB;
  state.R_WB = q_WB.toRotationMatrix();
}

inline void set_omega(LaneState& state, const Vector3L& inertia_B, const Vector3L& omega_W) {
  state.omega_W = omega_W;
  state.L_W = formulas::times_inertia_W(state.R_WB, inertia_B, omega_W);
}

inline void set_angular_momentum(LaneState& state, const Vector3L& inertia_B, const Vector3L& L_W) {
  state.L_W = L_W;
  state.omega_W = formulas::times_inverse_inertia_W(state.R_WB, inertia_B, L_W);
}

/// @name One of the bodies
/// What is not in lanes is left as it is.
/// @{
template <class Lanes, class Doubles>
void get_lane(std::size_t lane, const Lanes& values, Doubles& result) {
  for (int i = 0; i < Lanes::SizeAtCompileTime; ++i) result.coeffRef(i) = values.coeff(i)[lane];
}

inline void get_lane(std::size_t lane, const LaneInput& input, StepInput& result) {
  get_lane(lane, input.inertia_B, result.inertia_B);
  get_lane(lane, input.delta_omega_W, result.delta_omega_W);
  result.dt = input.dt[lane];
  result.turn_dt = input.turn_dt[lane];
}

inline void get_lane(std::size_t lane, const LaneState& state, RotationState& result) {
  get_lane(lane, state.q_WB.coeffs(), result.q_WB.coeffs());
  get_lane(lane, state.R_WB, result.R_WB);
  get_lane(lane, state.omega_W, result.omega_W);
  get_lane(lane, state.L_W, result.L_W);
}

template <class Doubles, class Lanes>
void set_lane(std::size_t lane, const Doubles& values, Lanes& result) {
  for (int i = 0; i < Lanes::SizeAtCompileTime; ++i) result.coeffRef(i).set(lane, values.coeff(i));
}

inline void set_lane(std::size_t lane, const RotationState& state, LaneState& result) {
  set_lane(lane, state.q_WB.coeffs(), result.q_WB.coeffs());
  set_lane(lane, state.R_WB, result.R_WB);
  set_lane(lane, state.omega_W, result.omega_W);
  set_lane(lane, state.L_W, result.L_W);
}
/// @}

/// In each lane `a` where the mask holds, else `b`.
inline LaneState select(const LaneMask& mask, const LaneState& a, const LaneState& b) {
  return {QuaternionL(select(mask, a.q_WB.coeffs(), b.q_WB.coeffs())), select(mask, a.R_WB, b.R_WB),
          select(mask, a.omega_W, b.omega_W), select(mask, a.L_W, b.L_W)};
}

}  // namespace polhode
