// omega_B = L_B/transverse + L_3 (1/axial - 1/transverse) e_3, and L_3 is constant: Landau & Lifshitz,
// section 33.
#include "oracle/symmetric_top.h"

#include <cmath>

namespace polhode::oracle {

namespace {

Quaternion turn_about(const Vector3& axis, double angle) {
  return Quaternion(Eigen::AngleAxisd(angle, axis.stableNormalized()));
}

}  // namespace

SymmetricTop::SymmetricTop(double transverse, double axial, const Quaternion& q_WB, const Vector3& L_W)
    : transverse_(transverse), axial_(axial), start_q_WB_(q_WB.normalized()), L_W_(L_W) {}

RotationState SymmetricTop::at(double t_s) const {
  const double L_3 = (start_q_WB_.conjugate() * L_W_).z();
  const Quaternion about_L = turn_about(L_W_, L_W_.norm() / transverse_ * t_s);
  const Quaternion about_axis = turn_about(Vector3::UnitZ(), L_3 * (1.0 / axial_ - 1.0 / transverse_) * t_s);
  RotationState state;
  state.q_WB = about_L * start_q_WB_ * about_axis;
  state.R_WB = state.q_WB.toRotationMatrix();
  state.L_W = L_W_;
  state.omega_W =
      state.R_WB * (state.R_WB.transpose() * L_W_).cwiseQuotient(Vector3(transverse_, transverse_, axial_));
  return state;
}

}  // namespace polhode::oracle
