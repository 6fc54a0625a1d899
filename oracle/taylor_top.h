#pragma once

#include <memory>

#include "polhode/rotation_state.h"

namespace polhode::oracle {

/// Integrates torque-free rotation, of a body with or without rotors, in Taylor series of order 36 with 50
/// digits. Tests FreeTop, with which it shares no code. The equations are
///   dL_B/dt = L_B x omega_B,  omega_B = I_B^-1 (L_B - h),  dq_WB/dt = 1/2 q_WB [0, omega_B].
/// Steps are short enough for a truncation error below 1e-40. An expansion takes about 3 ms and reaches a few
/// tenths of a rad; a step within it takes about 0.1 ms.
class TaylorTop {
 public:
  /// rotor_B is h, the angular momentum of the rotors, constant in body axes.
  TaylorTop(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& L_W,
            const Vector3& rotor_B = Vector3::Zero());
  ~TaylorTop();

  void advance(double t_s);

  Quaternion q_WB() const;
  Vector3 L_B() const;
  /// Same as FreeTop::attitude_error.
  double attitude_error(const Quaternion& q_WB) const;
  /// Returns the relative change of q_WB L_B and |q_WB| since the start. The integration does not enforce
  /// that they are constant.
  double drift() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace polhode::oracle
