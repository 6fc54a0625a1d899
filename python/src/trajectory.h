#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <vector>

#include "record/sample.h"

namespace polhode::python {

namespace py = pybind11;

/// A run column by column: the start, each sample whose step is a multiple of `every`, and the last.
class Trajectory {
 public:
  explicit Trajectory(std::int64_t every) : every_(every) {}

  void add(const demos::Sample& sample);

  /// Returns the arrays by name, and gives away their memory. Call with the GIL.
  py::dict finish();

 private:
  void append(const demos::Sample& sample);

  std::int64_t every_;
  std::optional<demos::Sample> left_out_;  ///< the last sample, if it was not taken
  std::vector<double> t_s_, q_WB_, R_WB_, omega_W_, L_W_, rotor_momentum_B_, position_W_, energy_J_, det_R_,
      attitude_error_rad_;
};

}  // namespace polhode::python
