#include "record/figures.h"

#include <algorithm>
#include <cmath>

#include "polhode/rotation_math.h"

namespace polhode::demos {

namespace {

double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

bool Sample::all_finite() const {
  return state.all_finite() && std::isfinite(energy_J);
}

FiguresRecorder::FiguresRecorder(const Sample& start, double dt)
    : start_energy_J_(start.energy_J), start_L_W_(start.state.L_W), dt_(dt) {
  if (start_energy_J_ != 0.0) figures_.worst_energy_error = 0.0;
  if (!start_L_W_.isZero(0.0)) {
    figures_.worst_momentum_error = 0.0;
    figures_.worst_momentum_angle_rad = 0.0;
  }
  add_energy(start.energy_J);
  add_attitude(start.attitude_error_rad);
  figures_.final_det_R = start.det_R();
}

void FiguresRecorder::add(const Sample& sample) {
  figures_.steps = sample.step;
  figures_.final_det_R = sample.det_R();
  if (sample.state.omega_W.norm() * dt_ > kBulletTurnLimit) ++figures_.steps_past_cut;
  add_energy(sample.energy_J);
  add_momentum(sample.state.L_W);
  add_attitude(sample.attitude_error_rad);
}

void FiguresRecorder::add_energy(double energy_J) {
  if (!figures_.worst_energy_error) return;
  const double error = energy_J / start_energy_J_ - 1.0;
  figures_.final_energy_error = error;
  figures_.worst_energy_error = std::max(*figures_.worst_energy_error, std::abs(error));
}

void FiguresRecorder::add_momentum(const Vector3& L_W) {
  if (!figures_.worst_momentum_error) return;
  const double error = std::abs(L_W.norm() / start_L_W_.norm() - 1.0);
  figures_.worst_momentum_error = std::max(*figures_.worst_momentum_error, error);
  figures_.worst_momentum_angle_rad =
      std::max(*figures_.worst_momentum_angle_rad, angle_between(L_W, start_L_W_));
}

void FiguresRecorder::add_attitude(const std::optional<double>& error_rad) {
  figures_.final_attitude_error_rad = error_rad;
  // An absent one is less than any.
  figures_.worst_attitude_error_rad = std::max(figures_.worst_attitude_error_rad, error_rad);
}

}  // namespace polhode::demos
