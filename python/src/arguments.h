#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "polhode/rotation_state.h"

/// Reads what Python passes. An error names the argument and says what is valid: TypeError for what is no
/// number, ValueError for a wrong shape or range.
namespace polhode::python {

namespace py = pybind11;

/// Three finite numbers, or one that stands for all of them if that is 0.
Vector3 read_vector(const py::handle& value, const char* name);
/// Four finite numbers w, x, y, z, not all 0, made a unit quaternion.
Quaternion read_quaternion(const py::handle& value, const char* name);
/// 3 by 3 finite numbers.
Matrix3 read_matrix(const py::handle& value, const char* name);
/// Three principal moments, each above 0.
Vector3 read_inertia(const py::handle& value);
/// A finite number other than 0.
double read_time_step(double dt);

/// @name Arrays that cannot be written to
/// A copy: assigning to its elements would change nothing else.
/// @{
py::array_t<double> to_array(const Vector3& v);
py::array_t<double> to_array(const Quaternion& q);  ///< w, x, y, z
py::array_t<double> to_array(const Matrix3& m);
/// @}

}  // namespace polhode::python
