#include "trajectory.h"

#include <pybind11/numpy.h>

#include <limits>
#include <memory>
#include <utility>

namespace polhode::python {

namespace {

void append_vector(const Vector3& v, std::vector<double>& column) {
  column.insert(column.end(), v.data(), v.data() + 3);
}

// The array owns what was the column's.
py::array array_of(std::vector<double>& column, std::vector<py::ssize_t> shape) {
  auto data = std::make_unique<std::vector<double>>(std::move(column));
  shape.insert(shape.begin(), -1);
  py::ssize_t numbers_per_record = 1;
  for (std::size_t i = 1; i < shape.size(); ++i) numbers_per_record *= shape[i];
  shape[0] = static_cast<py::ssize_t>(data->size()) / numbers_per_record;
  double* numbers = data->data();
  const py::capsule owner(data.release(),
                          [](void* owned) { delete static_cast<std::vector<double>*>(owned); });
  return py::array_t<double>(shape, numbers, owner);
}

}  // namespace

void Trajectory::add(const demos::Sample& sample) {
  if (sample.step % every_ == 0) {
    append(sample);
    left_out_.reset();
  } else {
    left_out_ = sample;
  }
}

void Trajectory::append(const demos::Sample& sample) {
  const RotationState& state = sample.state;
  t_s_.push_back(sample.t_s);
  for (const double x : {state.q_WB.w(), state.q_WB.x(), state.q_WB.y(), state.q_WB.z()}) q_WB_.push_back(x);
  const Matrix3 rows = state.R_WB.transpose();
  R_WB_.insert(R_WB_.end(), rows.data(), rows.data() + 9);
  append_vector(state.omega_W, omega_W_);
  append_vector(state.L_W, L_W_);
  append_vector(state.rotor_momentum_B, rotor_momentum_B_);
  append_vector(sample.position_W, position_W_);
  energy_J_.push_back(sample.energy_J);
  det_R_.push_back(sample.det_R());
  attitude_error_rad_.push_back(sample.attitude_error_rad.value_or(std::numeric_limits<double>::quiet_NaN()));
}

py::dict Trajectory::finish() {
  if (left_out_) append(*left_out_);
  py::dict columns;
  columns["t_s"] = array_of(t_s_, {});
  columns["q_WB"] = array_of(q_WB_, {4});
  columns["R_WB"] = array_of(R_WB_, {3, 3});
  columns["omega_W"] = array_of(omega_W_, {3});
  columns["L_W"] = array_of(L_W_, {3});
  columns["rotor_momentum_B"] = array_of(rotor_momentum_B_, {3});
  columns["position_W"] = array_of(position_W_, {3});
  columns["energy_J"] = array_of(energy_J_, {});
  columns["det_R"] = array_of(det_R_, {});
  columns["attitude_error_rad"] = array_of(attitude_error_rad_, {});
  return columns;
}

}  // namespace polhode::python
