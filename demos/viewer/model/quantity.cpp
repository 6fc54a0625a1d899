#include "viewer/model/quantity.h"

#include "record/errors.h"

namespace polhode::demos {

namespace {

/// The part of the rotational energy that belongs to one axis of the body, without its rotors.
double axis_energy(const RotationState& state, int axis) {
  const Vector3 omega_B = state.q_WB.conjugate() * state.omega_W;
  const Vector3 L_B = state.q_WB.conjugate() * state.L_W - state.rotor_momentum_B;
  return 0.5 * omega_B[axis] * L_B[axis];
}

}  // namespace

std::optional<double> value_of(Quantity quantity, const Sample& sample, const Sample& start) {
  switch (quantity) {
    case Quantity::energy:
      return sample.energy_J;
    case Quantity::energy_x:
      return axis_energy(sample.state, 0);
    case Quantity::energy_y:
      return axis_energy(sample.state, 1);
    case Quantity::energy_z:
      return axis_energy(sample.state, 2);
    case Quantity::momentum:
      return sample.state.L_W.norm();
    case Quantity::momentum_angle:
      return momentum_angle_rad(sample, start);
    case Quantity::determinant:
      return sample.det_R();
    case Quantity::attitude_error:
      return sample.attitude_error_rad;
  }
  return std::nullopt;
}

}  // namespace polhode::demos
