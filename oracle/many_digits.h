#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

#include "polhode/rotation_state.h"

/// Vectors and quaternions with more digits than double.
namespace polhode::oracle {

using Real = boost::multiprecision::cpp_bin_float_50;
// Wide enough for exact products of the given doubles: a quantity that is exactly zero, such as the distance
// from the separatrix, must come out as zero.
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200>>;

template <class R>
using Triple = Eigen::Matrix<R, 3, 1>;
template <class R>
using Rotation = Eigen::Quaternion<R, Eigen::DontAlign>;

inline const Real kPi = boost::math::constants::pi<Real>();

template <class R>
R square(const R& value) {
  return value * value;
}

template <class R>
Rotation<R> widened(const Quaternion& q) {
  return {R(q.w()), R(q.x()), R(q.y()), R(q.z())};
}

template <class To, class From>
Rotation<To> converted(const Rotation<From>& q) {
  return {static_cast<To>(q.w()), static_cast<To>(q.x()), static_cast<To>(q.y()), static_cast<To>(q.z())};
}

template <class To, class From>
Triple<To> converted(const Triple<From>& v) {
  return {static_cast<To>(v.x()), static_cast<To>(v.y()), static_cast<To>(v.z())};
}

}  // namespace polhode::oracle
