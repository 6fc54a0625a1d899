#pragma once

#include <memory>

#include "polhode/rotation_state.h"

namespace polhode::oracle {

/// The torque-free rotation once more, to test FreeTop, with which it shares nothing, and that of bodies with rotors
/// inside: Taylor series of Euler's equations dL_B/dt = L_B x omega_B, omega_B = I_B^-1 (L_B - h), and of
/// dq_WB/dt = 1/2 q_WB [0, omega_B] in 50 digits, of order 36, whose expansions keep the terms left out below 1e-40.
/// An expansion takes some 3 ms and reaches a few tenths of a rad; within it a step takes some 0.1 ms.
class TaylorTop {
 public:
  /// rotor_B: h, the angular momentum of the rotors, constant in body axes.
  TaylorTop(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& L_W,
            const Vector3& rotor_B = Vector3::Zero());
  ~TaylorTop();

  void advance(double t_s);

  Quaternion q_WB() const;
  Vector3 L_B() const;
  /// Returns the error as FreeTop::attitude_error does.
  double attitude_error(const Quaternion& q_WB) const;
  /// Returns how far q_WB L_B and |q_WB| have moved from the start, relative to it. The integration does not
  /// impose that they are kept.
  double drift() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace polhode::oracle
