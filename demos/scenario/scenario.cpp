#include "scenario/scenario.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scenario/number_text.h"

namespace polhode::demos {

bool Scenario::is_torque_free() const {
  return torque_W.isZero(0.0) && body.damping.angular == 0.0 && body.drive.is_torque_free() && !constraint &&
         !ground && others.empty();
}

bool Scenario::has_rotors() const {
  return body.drive.has_rotors() || std::any_of(others.begin(), others.end(),
                                                [](const Body& other) { return other.drive.has_rotors(); });
}

std::int64_t step_count(double dt, double duration) {
  const double steps = duration / dt;
  // 1 s in steps of 1/60 s written with few digits may give slightly less than a whole number of steps.
  constexpr double kRoundingSlack = 1e-6;
  if (!(steps >= 1.0 - kRoundingSlack && steps <= kMostSteps)) {
    throw std::invalid_argument("duration / dt must be between 1 and " + number_text(kMostSteps) +
                                " steps, is " + number_text(duration) + " s / " + number_text(dt) +
                                " s = " + number_text(steps));
  }
  return std::llround(steps);
}

}  // namespace polhode::demos
