#include "record/series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "polhode/rotation_math.h"
#include "record/errors.h"

namespace polhode::demos {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

void append(double value, std::vector<float>& column) {
  column.push_back(static_cast<float>(value));
}

template <class Values>
void append_all(const Values& values, std::vector<float>& column) {
  for (Eigen::Index i = 0; i < values.size(); ++i) append(values.data()[i], column);
}

// A missing error counts as less than any number.
void take_larger(double error, double& worst) {
  if (!(std::abs(worst) >= std::abs(error))) worst = error;
}

}  // namespace

SeriesRecorder::SeriesRecorder(const Vector3& inertia_B, double dt, std::int64_t steps,
                               std::size_t most_records)
    : inertia_B_(inertia_B), dt_(dt) {
  const auto most = static_cast<std::int64_t>(most_records);
  series_.stride = std::max<std::int64_t>(1, (steps + most - 1) / most);
}

void SeriesRecorder::add(const Sample& sample) {
  if (!start_) {
    start_ = sample;
    worst_ = errors_of(sample);
    end_stretch(sample);
    return;
  }
  const Errors errors = errors_of(sample);
  if (steps_in_stretch_ == 0) worst_ = errors;
  take_larger(errors.energy, worst_.energy);
  take_larger(errors.momentum, worst_.momentum);
  take_larger(errors.momentum_angle_rad, worst_.momentum_angle_rad);
  take_larger(errors.attitude_rad, worst_.attitude_rad);
  if (is_past_cut(sample, dt_)) ++past_cut_;
  last_ = sample;
  ++steps_in_stretch_;
  if (steps_in_stretch_ == series_.stride) end_stretch(sample);
}

Series SeriesRecorder::finish() {
  if (steps_in_stretch_ > 0) end_stretch(*last_);
  return std::move(series_);
}

SeriesRecorder::Errors SeriesRecorder::errors_of(const Sample& sample) const {
  return {
      energy_error(sample, *start_).value_or(kUnknown), momentum_error(sample, *start_).value_or(kUnknown),
      momentum_angle_rad(sample, *start_).value_or(kUnknown), sample.attitude_error_rad.value_or(kUnknown)};
}

void SeriesRecorder::end_stretch(const Sample& sample) {
  const RotationState& state = sample.state;
  append(sample.t_s, series_.t_s);
  append(sample.energy_J, series_.energy_J);
  // L.omega/2 with omega = R I^-1 R^T L, term by term: also of a basis that is no rotation. L without the rotors.
  const Vector3 L_B = state.R_WB.transpose() * state.L_W - state.rotor_momentum_B;
  const Vector3 energies = 0.5 * L_B.cwiseAbs2().cwiseQuotient(inertia_B_);
  append(energies.x(), series_.energy_x_J);
  append(energies.y(), series_.energy_y_J);
  append(energies.z(), series_.energy_z_J);
  append(sample.det_R(), series_.det_R);
  append_all(state.R_WB, series_.R_WB);
  append_all(sample.position_W, series_.position_W);
  append_all(state.omega_W, series_.omega_W);
  append_all(state.L_W, series_.L_W);
  append_all(Vector3(state.R_WB * state.rotor_momentum_B), series_.rotor_momentum_W);
  append(worst_.energy, series_.energy_error);
  append(worst_.momentum, series_.momentum_error);
  append(worst_.momentum_angle_rad, series_.momentum_angle_rad);
  append(worst_.attitude_rad, series_.attitude_error_rad);
  append(static_cast<double>(past_cut_), series_.past_cut);
  steps_in_stretch_ = 0;
  past_cut_ = 0;
}

}  // namespace polhode::demos
