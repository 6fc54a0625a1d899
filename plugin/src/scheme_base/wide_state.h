#pragma once

#include <optional>
#include <type_traits>

#include "math/rotation.h"
#include "polhode/rotation_scheme.h"
#include "simd/wide.h"

/// StepInput and RotationState for eight bodies, with the matching functions of rotation_math.h.
namespace polhode {

struct WideStepInput {
  Vector3Wide inertia_B;
  Vector3Wide delta_omega_W;
  Wide dt;
};

struct WideState {
  QuaternionWide q_WB;
  Matrix3Wide R_WB;
  Vector3Wide omega_W;
  Vector3Wide L_W;
  std::optional<Vector3Wide> rotor_momentum_B;  ///< empty if none of the eight bodies has a rotor
};

/// The types of a step that is written once for Real = double (one body) and Real = Wide (eight bodies).
template <class Real>
using StepInputOf = std::conditional_t<std::is_same_v<Real, double>, StepInput, WideStepInput>;
template <class Real>
using StateOf = std::conditional_t<std::is_same_v<Real, double>, RotationState, WideState>;

inline void set_orientation(WideState& state, const QuaternionWide& q_WB) {
  state.q_WB = q_WB;
  state.R_WB = q_WB.toRotationMatrix();
}

inline Vector3Wide without_rotor(const WideState& state, const Vector3Wide& L_W) {
  return state.rotor_momentum_B ? Vector3Wide(L_W - state.R_WB * *state.rotor_momentum_B) : L_W;
}

inline Vector3Wide with_rotor(const WideState& state, const Vector3Wide& body_momentum_W) {
  return state.rotor_momentum_B ? Vector3Wide(body_momentum_W + state.R_WB * *state.rotor_momentum_B)
                                : body_momentum_W;
}

inline void set_omega(WideState& state, const Vector3Wide& inertia_B, const Vector3Wide& omega_W) {
  state.omega_W = omega_W;
  state.L_W = with_rotor(state, formulas::times_inertia_W(state.R_WB, inertia_B, omega_W));
}

inline void set_angular_momentum(WideState& state, const Vector3Wide& inertia_B, const Vector3Wide& L_W) {
  state.L_W = L_W;
  state.omega_W = formulas::times_inverse_inertia_W(state.R_WB, inertia_B, without_rotor(state, L_W));
}

/// @name Access to one body
/// @{
template <class Values, class Doubles>
void get_lane(std::size_t lane, const Values& values, Doubles& result) {
  for (int i = 0; i < Values::SizeAtCompileTime; ++i) result.coeffRef(i) = values.coeff(i)[lane];
}

inline void get_lane(std::size_t lane, const WideStepInput& input, StepInput& result) {
  get_lane(lane, input.inertia_B, result.inertia_B);
  get_lane(lane, input.delta_omega_W, result.delta_omega_W);
  result.dt = input.dt[lane];
}

inline void get_lane(std::size_t lane, const WideState& state, RotationState& result) {
  get_lane(lane, state.q_WB.coeffs(), result.q_WB.coeffs());
  get_lane(lane, state.R_WB, result.R_WB);
  get_lane(lane, state.omega_W, result.omega_W);
  get_lane(lane, state.L_W, result.L_W);
  if (state.rotor_momentum_B) {
    get_lane(lane, *state.rotor_momentum_B, result.rotor_momentum_B);
  } else {
    result.rotor_momentum_B.setZero();
  }
}

template <class Doubles, class Values>
void set_lane(std::size_t lane, const Doubles& values, Values& result) {
  for (int i = 0; i < Values::SizeAtCompileTime; ++i) result.coeffRef(i).set(lane, values.coeff(i));
}

inline void set_lane(std::size_t lane, const StepInput& input, WideStepInput& result) {
  set_lane(lane, input.inertia_B, result.inertia_B);
  set_lane(lane, input.delta_omega_W, result.delta_omega_W);
  result.dt.set(lane, input.dt);
}

inline void set_lane(std::size_t lane, const RotationState& state, WideState& result) {
  set_lane(lane, state.q_WB.coeffs(), result.q_WB.coeffs());
  set_lane(lane, state.R_WB, result.R_WB);
  set_lane(lane, state.omega_W, result.omega_W);
  set_lane(lane, state.L_W, result.L_W);
  if (!state.has_rotor() && !result.rotor_momentum_B) return;
  if (!result.rotor_momentum_B) result.rotor_momentum_B = Vector3Wide::Constant(Wide(0.0));
  set_lane(lane, state.rotor_momentum_B, *result.rotor_momentum_B);
}
/// @}

/// Returns `a` in the lanes of the mask, `b` in the others. Either both have rotors or neither has.
inline WideState select(const WideMask& mask, const WideState& a, const WideState& b) {
  WideState result = {QuaternionWide(select(mask, a.q_WB.coeffs(), b.q_WB.coeffs())),
                      select(mask, a.R_WB, b.R_WB), select(mask, a.omega_W, b.omega_W),
                      select(mask, a.L_W, b.L_W), std::nullopt};
  if (a.rotor_momentum_B) result.rotor_momentum_B = select(mask, *a.rotor_momentum_B, *b.rotor_momentum_B);
  return result;
}

}  // namespace polhode
