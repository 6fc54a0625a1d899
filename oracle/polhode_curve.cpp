#include "oracle/polhode_curve.h"

#include <algorithm>

namespace polhode::oracle {

namespace {

/// Returns true if the body is at rest or rotates about a principal axis.
bool is_steady(const Triple<Wide>& L_B) {
  return std::count(L_B.begin(), L_B.end(), Wide(0)) >= 2;
}

void make_right_handed(Axes& axes, const Triple<Wide>& L_B) {
  for (Axis* axis : {&axes[0], &axes[2]}) axis->sign = L_B[axis->index] < 0 ? -1 : 1;
  const bool cyclic = (axes[1].index - axes[0].index + 3) % 3 == 1;
  axes[1].sign = (cyclic ? 1 : -1) * axes[0].sign * axes[2].sign;
}

/// Returns (|L|^2 - 2 T I2) |I1 - I3|, up to a positive factor: above 0 if the polhode goes round axis 3,
/// below 0 if round axis 1, 0 on the separatrix. Exact: no division, no square root.
Wide side_of_separatrix(const Triple<Wide>& inertia, const Triple<Wide>& L) {
  return square(L[2]) * abs(inertia[2] - inertia[1]) * inertia[0] -
         square(L[0]) * abs(inertia[1] - inertia[0]) * inertia[2];
}

/// Returns the components along P's axes, without their signs.
Triple<Wide> ordered(const Triple<Wide>& v_B, const Axes& axes) {
  return {v_B[axes[0].index], v_B[axes[1].index], v_B[axes[2].index]};
}

Polhode steady_polhode(const Real& inertia, const Real& L) {
  Polhode polhode;
  polhode.I1 = polhode.I3 = inertia;
  polhode.L = L;
  polhode.sine = 1;
  polhode.cosine = 0;
  return polhode;
}

/// Takes y = L_P and the moments in the order of P's axes. The motion must not be steady.
Polhode polhode_through(const Triple<Wide>& inertia, const Triple<Wide>& y) {
  const Wide &I1 = inertia[0], &I2 = inertia[1], &I3 = inertia[2];
  const Wide d21 = abs(I2 - I1), d32 = abs(I3 - I2), d31 = abs(I3 - I1);
  // Relative to d31. For a sphere the choice of axis does not matter.
  const Wide part32 = d31 == 0 ? Wide(1) : Wide(d32 / d31), part21 = d31 == 0 ? Wide(0) : Wide(d21 / d31);
  const Wide A_squared = square(y[0]) + square(y[1]) * I1 * part32 / I2;
  const Wide C_squared = square(y[2]) + square(y[1]) * I3 * part21 / I2;
  const Wide B_squared = A_squared * I2 / (I1 * part32);
  const Wide L_squared = y.squaredNorm();
  Polhode polhode;
  polhode.I1 = Real(I1);
  polhode.I3 = Real(I3);
  polhode.L = Real(sqrt(L_squared));
  polhode.sine = Real(sqrt(C_squared / L_squared));
  polhode.cosine = Real(sqrt(A_squared / L_squared));
  if (d21 != 0) {
    polhode.m = Real(d21 * I3 * A_squared / (d32 * I1 * C_squared));
    polhode.m1 = Real(side_of_separatrix(inertia, y) / (d32 * I1 * C_squared));
    polhode.u0_delta = Real(y[2] / sqrt(C_squared));
  }
  polhode.nu = Real(sqrt(C_squared * d32 * d31 / (I1 * I2)) / I3) * (I3 > I1 ? 1 : -1);
  polhode.u0_sine = Real(y[1] / sqrt(B_squared));
  polhode.u0_cosine = Real(y[0] / sqrt(A_squared));
  if (d31 != 0) {
    polhode.s_sine_squared = Real(I1 * d32 / (I2 * d31));
    polhode.s_cosine_squared = Real(I3 * d21 / (I2 * d31));
  }
  return polhode;
}

}  // namespace

Rotation<Real> rotation_of(const Axes& axes) {
  Eigen::Matrix<Real, 3, 3> R_BP = Eigen::Matrix<Real, 3, 3>::Zero();
  for (int i = 0; i < 3; ++i) R_BP(axes[i].index, i) = axes[i].sign;
  return Rotation<Real>(R_BP).normalized();
}

Axes polhode_axes(const Triple<Wide>& inertia_B, const Triple<Wide>& L_B) {
  Axes axes{{{0}, {1}, {2}}};
  std::sort(axes.begin(), axes.end(),
            [&](const Axis& a, const Axis& b) { return inertia_B[a.index] < inertia_B[b.index]; });
  if (is_steady(L_B)) {
    const auto spun =
        std::find_if(axes.begin(), axes.end(), [&](const Axis& a) { return L_B[a.index] != 0; });
    if (spun != axes.end()) std::swap(*spun, axes[2]);
  } else {
    const Triple<Wide> inertia = ordered(inertia_B, axes);
    // The polhode of a symmetric top goes round its symmetry axis.
    if (side_of_separatrix(inertia, ordered(L_B, axes)) < 0 || inertia[2] == inertia[1]) {
      std::swap(axes[0], axes[2]);
    }
  }
  make_right_handed(axes, L_B);
  return axes;
}

Polhode polhode_of(const Triple<Wide>& inertia_B, const Triple<Wide>& L_B, const Axes& axes) {
  if (is_steady(L_B)) return steady_polhode(Real(inertia_B[axes[2].index]), Real(L_B.norm()));
  Triple<Wide> L_P = ordered(L_B, axes);
  for (int i = 0; i < 3; ++i) L_P[i] *= axes[i].sign;
  return polhode_through(ordered(inertia_B, axes), L_P);
}

}  // namespace polhode::oracle
