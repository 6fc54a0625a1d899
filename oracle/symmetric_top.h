#pragma once

#include "polhode/rotation_state.h"

namespace polhode::oracle {

/// The torque-free rotation of a body with inertia_B = (transverse, transverse, axial), in elementary
/// functions: the body turns about L_W at the rate |L|/transverse, and about its own axis 3 at L_3 (1/axial -
/// 1/transverse).
class SymmetricTop {
 public:
  SymmetricTop(double transverse, double axial, const Quaternion& q_WB, const Vector3& L_W);
  RotationState at(double t_s) const;

 private:
  double transverse_, axial_;
  Quaternion start_q_WB_;
  Vector3 L_W_;
};

}  // namespace polhode::oracle
