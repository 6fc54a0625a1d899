#include "arguments.h"

#include <cmath>
#include <string>
#include <vector>

namespace polhode::python {

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Shape = std::vector<py::ssize_t>;

std::string must_be(const char* name, const char* valid) {
  return std::string(name) + " must be " + valid;
}

std::string is(const py::handle& value) {
  return ", is " + py::repr(value).cast<std::string>();
}

Array read_numbers(const py::handle& value, const char* name, const char* valid) {
  Array array = Array::ensure(value);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(must_be(name, valid) + is(value));
  }
  return array;
}

Array read_array(const py::handle& value, const char* name, const Shape& shape, const char* valid) {
  Array array = read_numbers(value, name, valid);
  if (Shape(array.shape(), array.shape() + array.ndim()) != shape) {
    throw py::value_error(must_be(name, valid) + ", has shape " +
                          py::repr(array.attr("shape")).cast<std::string>());
  }
  for (py::ssize_t i = 0; i < array.size(); ++i) {
    if (!std::isfinite(array.data()[i])) {
      throw py::value_error(must_be(name, valid) + is(array));
    }
  }
  return array;
}

py::array_t<double> array_of(const Shape& shape, const double* data) {
  py::array_t<double> array(shape, data);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

}  // namespace

Vector3 read_vector(const py::handle& value, const char* name) {
  constexpr char kValid[] = "three finite numbers";
  const Array numbers = read_numbers(value, name, kValid);
  if (numbers.ndim() == 0 && *numbers.data() == 0.0) return Vector3::Zero();
  return Vector3(read_array(numbers, name, {3}, kValid).data());
}

Quaternion read_quaternion(const py::handle& value, const char* name) {
  constexpr char kValid[] = "four finite numbers w, x, y, z that are not all 0";
  const Array numbers = read_array(value, name, {4}, kValid);
  const double* wxyz = numbers.data();
  const Quaternion q(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  const double length = q.norm();
  if (!std::isfinite(length) || length < 1e-12) throw py::value_error(must_be(name, kValid));
  // What has unit length already keeps its bits.
  if (std::abs(length - 1.0) < 1e-15) return q;
  return Quaternion(q.normalized());
}

Matrix3 read_matrix(const py::handle& value, const char* name) {
  const Array numbers = read_array(value, name, {3, 3}, "3 by 3 finite numbers");
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
}

Vector3 read_inertia(const py::handle& value) {
  constexpr char kValid[] = "three principal moments in kg m^2, each finite and above 0";
  const Array numbers = read_array(value, "inertia_B", {3}, kValid);
  const Vector3 inertia_B(numbers.data());
  if (inertia_B.minCoeff() <= 0.0) {
    throw py::value_error(must_be("inertia_B", kValid) + is(numbers));
  }
  return inertia_B;
}

double read_time_step(double dt) {
  if (std::isfinite(dt) && dt != 0.0) return dt;
  throw py::value_error("dt must be a finite number of seconds other than 0, is " + std::to_string(dt));
}

py::array_t<double> to_array(const Vector3& v) {
  return array_of({3}, v.data());
}

py::array_t<double> to_array(const Quaternion& q) {
  const double wxyz[] = {q.w(), q.x(), q.y(), q.z()};
  return array_of({4}, wxyz);
}

py::array_t<double> to_array(const Matrix3& m) {
  const Matrix3 rows = m.transpose();
  return array_of({3, 3}, rows.data());
}

}  // namespace polhode::python
