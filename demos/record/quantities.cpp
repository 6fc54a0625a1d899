#include "record/quantities.h"

#include <algorithm>

#include "record/errors.h"

namespace polhode::demos {

namespace {

using Value = std::optional<double>;

constexpr const char* kNotInCsv = "";
constexpr const char* kNoPlot = "";

// Returns one term of L.omega/2 with omega = R I^-1 R^T L, and L without the rotors. Valid even if the basis
// is not a rotation.
double axis_energy_J(const Instant& at, int axis) {
  const RotationState& state = at.sample.state;
  const double L = state.R_WB.col(axis).dot(state.L_W) - state.rotor_momentum_B[axis];
  return 0.5 * L * L / at.inertia_B[axis];
}

}  // namespace

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = {
      {"step", "step", "1", 1, Drawing::none, kNoPlot, "0 is the start",
       [](const Instant& at, int) -> Value { return static_cast<double>(at.sample.step); }},
      {"t_s", "t_s", "s", 1, Drawing::view, kNoPlot, "time since the start",
       [](const Instant& at, int) -> Value { return at.sample.t_s; }},
      {"q_WB", "q_w,q_x,q_y,q_z", "1", 4, Drawing::none, kNoPlot, "orientation, v_world = q v_body",
       [](const Instant& at, int i) -> Value { return at.sample.state.q_WB.coeffs()[(i + 3) % 4]; }},
      {"omega_W", "omega_x_rad_s,omega_y_rad_s,omega_z_rad_s", "rad/s", 3, Drawing::view, kNoPlot,
       "angular velocity, world axes",
       [](const Instant& at, int i) -> Value { return at.sample.state.omega_W[i]; }},
      {"L_W", "L_x,L_y,L_z", "kg m^2/s", 3, Drawing::view, kNoPlot,
       "angular momentum about the centre of mass, world axes",
       [](const Instant& at, int i) -> Value { return at.sample.state.L_W[i]; }},
      {"energy_error", kNotInCsv, "1", 1, Drawing::logarithmic, "energy error",
       "E/E0 - 1, the relative change of the total energy; unknown if E0 is 0",
       [](const Instant& at, int) { return energy_error(at.sample, at.start); }},
      {"momentum_error", kNotInCsv, "1", 1, Drawing::logarithmic, "|L| error",
       "|L|/|L0| - 1, the relative change of the length of L; unknown if L0 is 0",
       [](const Instant& at, int) { return momentum_error(at.sample, at.start); }},
      {"momentum_angle_rad", kNotInCsv, "rad", 1, Drawing::logarithmic, "turn of L",
       "angle between L and the initial L; unknown if the initial L is 0",
       [](const Instant& at, int) { return momentum_angle_rad(at.sample, at.start); }},
      {"energy_J", "energy_J", "J", 1, Drawing::linear, "energy",
       "rotational, translational and potential energy; the potential is zero at the height of the world's "
       "origin",
       [](const Instant& at, int) -> Value { return at.sample.energy_J; }},
      {"axis_energy_J", kNotInCsv, "J", 3, Drawing::linear, "energy about body axis",
       "I omega^2 / 2 about each axis: shows how energy moves from axis to axis in a tumbling body",
       [](const Instant& at, int i) -> Value { return axis_energy_J(at, i); }},
      {"det_R", "det_R", "1", 1, Drawing::adaptive, "det R",
       "determinant of the basis passed to Bullet: 1 for a rotation, else the factor by which the body's "
       "volume has changed",
       [](const Instant& at, int) -> Value { return at.sample.det_R(); }},
      {"attitude_error_rad", "attitude_error_rad", "rad", 1, Drawing::logarithmic, "attitude error",
       "angle between the orientation and the exact one; known for torque-free scenarios",
       [](const Instant& at, int) { return at.sample.attitude_error_rad; }},
      {"R_WB", kNotInCsv, "1", 9, Drawing::view, kNoPlot, "basis of the body, column by column",
       [](const Instant& at, int i) -> Value { return at.sample.state.R_WB.data()[i]; }},
      {"position_W", kNotInCsv, "m", 3, Drawing::view, kNoPlot, "centre of mass",
       [](const Instant& at, int i) -> Value { return at.sample.position_W[i]; }},
      {"rotor_momentum_W", kNotInCsv, "kg m^2/s", 3, Drawing::view, kNoPlot, "angular momentum of the rotors",
       [](const Instant& at, int i) -> Value {
         return at.sample.state.R_WB.row(i).dot(at.sample.state.rotor_momentum_B);
       }},
  };
  return all;
}

std::vector<const Quantity*> plotted_quantities() {
  std::vector<const Quantity*> plotted;
  for (const Quantity& quantity : quantities()) {
    if (quantity.is_plotted()) plotted.push_back(&quantity);
  }
  std::stable_partition(plotted.begin(), plotted.end(),
                        [](const Quantity* quantity) { return quantity->is_error(); });
  return plotted;
}

}  // namespace polhode::demos
