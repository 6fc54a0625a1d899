#pragma once

#include <array>

#include "simd/wide.h"

/// The order of a body's axes in the formulas of free motion. Real is double or Wide.
namespace polhode::free_top {

template <class Real>
using Triple = std::array<Real, 3>;

template <class Real>
POLHODE_INLINE Real square(const Real& x) {
  return x * x;
}

/// axis[0], axis[1], axis[2] are the axes 1, 2, 3 of the formulas: 0, 1, 2 for the body's x, y, z.
template <class Real>
using Axes = Triple<Real>;

/// Encodes the axes as one number, 0 to 5.
template <class Real>
POLHODE_INLINE Real order_of(const Axes<Real>& axes) {
  return 2.0 * axes[0] + select(axes[1] < axes[2], Real(0.0), Real(1.0));
}

/// Decodes order_of.
template <class Real>
POLHODE_INLINE Axes<Real> axes_of(const Real& order) {
  const Real first = select(order < 2.0, Real(0.0), select(order < 4.0, Real(1.0), Real(2.0)));
  // Of the two other axes, axis 3 is the greater one if the order is even.
  const Real least_other = select(order < 2.0, Real(1.0), Real(0.0));
  const Real greatest_other = select(order < 4.0, Real(2.0), Real(1.0));
  const auto is_even = order == 2.0 * first;
  return {first, select(is_even, least_other, greatest_other), select(is_even, greatest_other, least_other)};
}

/// Returns v_B in the order of the formulas.
template <class Real, class VectorB>
POLHODE_INLINE Triple<Real> in_order(const Axes<Real>& axes, const VectorB& v_B) {
  Triple<Real> v;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = select(axes[i] == 0.0, v_B[0], select(axes[i] == 1.0, v_B[1], v_B[2]));
  }
  return v;
}

/// Returns v in the order of the body.
template <class Real>
POLHODE_INLINE Eigen::Matrix<Real, 3, 1> in_body(const Axes<Real>& axes, const Triple<Real>& v) {
  Eigen::Matrix<Real, 3, 1> v_B;
  for (int i = 0; i < 3; ++i) {
    const double axis = i;
    v_B[i] = select(axes[0] == axis, v[0], select(axes[2] == axis, v[2], v[1]));
  }
  return v_B;
}

/// A body whose axes are in the order of the formulas.
template <class Real>
struct Labelled {
  Axes<Real> axes;
  Triple<Real> inertia;
  Triple<Real> u;  ///< L/|L|
  Real parity;     ///< of the axes as a permutation of x, y, z: 1 or -1

  template <class Condition>
  POLHODE_INLINE void swap_if(const Condition& condition, std::size_t i, std::size_t j) {
    for (Triple<Real>* triple : {&axes, &inertia, &u}) {
      const Real first = (*triple)[i];
      (*triple)[i] = select(condition, (*triple)[j], first);
      (*triple)[j] = select(condition, first, (*triple)[j]);
    }
    parity = select(condition, Real(-parity), parity);
  }
};

/// Sorts the axes by moments of inertia, so that axis 2 is the middle one and the polhode encloses axis 3.
template <class Real, class VectorB>
POLHODE_INLINE Labelled<Real> labelled(const VectorB& inertia_B, const VectorB& u_B) {
  Labelled<Real> body{
      {0.0, 1.0, 2.0}, {inertia_B[0], inertia_B[1], inertia_B[2]}, {u_B[0], u_B[1], u_B[2]}, 1.0};
  body.swap_if(body.inertia[1] < body.inertia[0], 0, 1);
  body.swap_if(body.inertia[2] < body.inertia[1], 1, 2);
  body.swap_if(body.inertia[1] < body.inertia[0], 0, 1);
  const auto& [I1, I2, I3] = body.inertia;
  // u3^2 d32 < u1^2 d21: the polhode encloses the axis of the least moment instead.
  const Real round_3 = square(body.u[2]) * (I3 - I2) * I1;
  const Real round_1 = square(body.u[0]) * (I2 - I1) * I3;
  body.swap_if(round_3 < round_1, 0, 2);
  return body;
}

}  // namespace polhode::free_top
