#pragma once

#include "math/rotation.h"
#include "polhode/rotation_math.h"
#include "polhode/rotation_scheme.h"
#include "scheme_base/wide_state.h"

/// The step of schemes with TurnVelocity::mean, which turn a body at constant momentum:
///
///   L_W <- L_W + I_W(q_t) delta_omega_W                kick
///   q_{t+1} = q_t rho_B(L_B, h),  L_B = q_t^-1 L_W     turn; h is the momentum of the rotors
///   omega_W = I_W(q_{t+1})^-1 (L_W - R(q_{t+1}) h)
///
/// For a torque this is symplectic Euler: of order 1; a spring's energy does not drift.
namespace polhode::schemes {

/// Returns L_W + I_W(q_t) delta_omega_W.
template <class Real>
formulas::Vector<Real> kicked_L_W(const StepInputOf<Real>& input, const StateOf<Real>& start) {
  return start.L_W + formulas::times_inertia_W<Real>(start.R_WB, input.inertia_B, input.delta_omega_W);
}

/// Free motion for dt, in body axes.
struct FreeMotion {
  Vector3 inertia_B;
  Vector3 L_B;      ///< at the start
  Vector3 rotor_B;  ///< h, constant
  double dt;
};

/// A built-in scheme that rotates by `free_turn`, which returns the rotation of free motion in body axes.
template <Quaternion (*free_turn)(const FreeMotion& motion)>
class KickAndTurnScheme final : public RotationScheme {
 public:
  explicit KickAndTurnScheme(const SchemeDescription& description) : description_(description) {}

  SchemeDescription description() const noexcept override { return description_; }

  void step(const StepInput& input, RotationState& state) const noexcept override {
    const Vector3 L_W = kicked_L_W<double>(input, state);
    if (!L_W.isZero(0.0) || state.has_rotor()) {  // a body at rest keeps its orientation bit for bit
      const Vector3 L_B = state.R_WB.transpose() * L_W;
      const Quaternion rho_B = free_turn({input.inertia_B, L_B, state.rotor_momentum_B, input.dt});
      set_orientation(state, (state.q_WB * rho_B).normalized());
    }
    set_angular_momentum(state, input.inertia_B, L_W);
  }

 private:
  SchemeDescription description_;
};

}  // namespace polhode::schemes
