// Operations of a side on torque laws and rotors.
#include <stdexcept>

#include "fuzz/world/side.h"
#include "polhode/bullet/conversions.h"
#include "polhode/torque_laws.h"

namespace polhode::fuzz {

namespace {

// Returns laws that work, that throw, or whose torque no step can take.
TorqueLaw law_of(const Operation& operation) {
  const Vector3 a = to_double(operation.a);
  const double x = static_cast<double>(operation.x);
  switch (operation.variant / 8) {
    case 0:
      return [](const TorqueLawInput& motion) { return BodyTorque{-0.5 * motion.omega_B()}; };
    case 1:
      return [a](const TorqueLawInput& motion) { return WorldTorque{(motion.q_WB * a).cross(a)}; };
    case 2:
      return [a, x](const TorqueLawInput& motion) {
        return WorldTorque{a * motion.time_s + x * motion.position_W.cross(motion.velocity_W)};
      };
    case 3:
      return [](const TorqueLawInput& motion) -> Torque {
        if (motion.omega_W.x() > 0.0) throw std::runtime_error("no torque this way");
        return WorldTorque{motion.omega_W};
      };
    case 4:
      return [a](const TorqueLawInput& motion) { return BodyTorque{a / motion.omega_W.y()}; };
    case 5:
      return [a](const TorqueLawInput&) { return RotorTorque{a}; };
    case 6:
      return internal_damping(0.3, 0.2);
    default:
      return [](const TorqueLawInput& motion) { return BodyTorque{1e8 * motion.omega_B()}; };
  }
}

}  // namespace

void Side::drive(const Operation& operation) {
  RotationControl& rotation = *worlds_[operation.world]->rotation;
  btRigidBody& body = *slots_[operation.slot].body();
  const Vector3 a = to_double(operation.a);
  const TorqueLawOrder order = operation.other % 2 == 0 ? TorqueLawOrder::two : TorqueLawOrder::four;
  may_have_rotors_ = true;
  try {
    switch (operation.variant % 8) {
      case 0:
      case 1:
      case 2:
        rotation.set_torque_law(body, law_of(operation), order);
        return;
      case 3:
        rotation.clear_torque_law(body);
        return;
      case 4:
        rotation.set_rotor_momentum(body, a, RotorChange::by_motor);
        return;
      case 5:
        rotation.set_rotor_momentum(body, a, RotorChange::from_outside);
        return;
      case 6:
        rotation.set_rotor_torque(body, a);
        return;
      default:
        rotation.set_time(static_cast<double>(operation.x));
    }
  } catch (const std::invalid_argument&) {
    // not rotated by the library, a scheme without rotors, or numbers that are not finite
  }
}

}  // namespace polhode::fuzz
