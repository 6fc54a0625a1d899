#include "record/figures.h"

#include <algorithm>
#include <cmath>

#include "record/errors.h"

namespace polhode::demos {

bool Sample::all_finite() const {
  return state.all_finite() && std::isfinite(energy_J);
}

FiguresRecorder::FiguresRecorder(const Sample& start, double dt) : start_(start), dt_(dt) {
  add_errors(start);
}

void FiguresRecorder::add(const Sample& sample) {
  figures_.steps = sample.step;
  if (is_past_cut(sample, dt_)) ++figures_.steps_past_cut;
  add_errors(sample);
}

// Treats an absent value as less than any number.
void FiguresRecorder::add_errors(const Sample& sample) {
  const auto take_larger = [](const std::optional<double>& error, std::optional<double>& worst) {
    if (error) worst = std::max(worst, std::optional(std::abs(*error)));
  };
  figures_.final_det_R = sample.det_R();
  figures_.final_energy_error = energy_error(sample, start_);
  take_larger(figures_.final_energy_error, figures_.worst_energy_error);
  take_larger(momentum_error(sample, start_), figures_.worst_momentum_error);
  take_larger(momentum_angle_rad(sample, start_), figures_.worst_momentum_angle_rad);
  figures_.final_attitude_error_rad = sample.attitude_error_rad;
  take_larger(sample.attitude_error_rad, figures_.worst_attitude_error_rad);
}

}  // namespace polhode::demos
