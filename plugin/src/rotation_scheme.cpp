#include "polhode/rotation_scheme.h"

#include "math/rotation.h"

namespace polhode {

std::string_view to_string(Conservation conservation) {
  switch (conservation) {
    case Conservation::exact:
      return "exactly";
    case Conservation::bounded:
      return "boundedly";
    case Conservation::lost:
      break;
  }
  return "not";
}

std::string_view to_string(TurnVelocity turn_velocity) {
  switch (turn_velocity) {
    case TurnVelocity::start:
      return "start";
    case TurnVelocity::end:
      return "end";
    case TurnVelocity::mean:
      break;
  }
  return "mean";
}

std::string order_text(std::optional<int> order) {
  return order ? std::to_string(*order) : "exact";
}

void RotationScheme::turn(const Vector3& omega_W, double dt, RotationState& state) const noexcept {
  set_orientation(state, formulas::turn_exponentially<double>(state.q_WB, omega_W, dt));
}

}  // namespace polhode
