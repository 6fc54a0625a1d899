#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "polhode/rotation_state.h"
#include "polhode/scheme_memory.h"

namespace polhode {

/// How well a scheme keeps a quantity of free motion.
enum class Conservation {
  exact,    ///< to rounding, for ever
  bounded,  ///< the error oscillates and does not grow with time
  lost,     ///< the error grows with time
};

std::string_view to_string(Conservation conservation);

/// "2", or "exact" for a motion without error.
std::string order_text(std::optional<int> order);

/// What a scheme says of itself. Tests hold every line of it against measurements.
struct SchemeDescription {
  std::string_view name;                     ///< as in `set_scheme("name")`, whole words in snake_case
  std::string_view summary;                  ///< one line
  std::string_view source;                   ///< paper or text, with equation numbers
  std::string_view fails_when;               ///< one line
  std::optional<int> order = 1;              ///< of convergence of the orientation in dt, in free motion;
                                             ///< none: there is no error but rounding
  Conservation energy = Conservation::lost;  ///< rotational kinetic energy
  Conservation angular_momentum = Conservation::lost;  ///< the vector L_W
  Conservation rotation = Conservation::exact;         ///< R_WB stays a rotation: det R_WB = 1
};

/// What one step is told, besides the state at its start.
struct StepInput {
  Vector3 inertia_B;      ///< principal moments, kg m^2, each > 0; need not obey the triangle inequality
  Vector3 delta_omega_W;  ///< what the solver changed in this step (torques, contacts, joints), rad/s
  double dt;              ///< length of the step, s
  double turn_dt;         ///< the part of dt that the orientation moves through, s: less than dt only where
                          ///< continuous collision detection stopped the body within the step

  /// The torque on the body, N m, where it alone changed the velocity: delta_omega_W is then
  /// dt I_W^-1 torque_W as Bullet rounds it. Zero where anything else acted too.
  Vector3 torque_W = Vector3::Zero();
  bool torque_turns_with_body = false;  ///< torque_W holds at the start and turns with the body's axes
};

/// One body's part in RotationScheme::step_bodies.
struct BodyStep {
  const StepInput* input;
  RotationState* state;
  SchemeMemory* memory;
};

/// A way to rotate a body. Stateless: one object serves any number of bodies, worlds and threads.
/// Applications derive their own and attach it like a built-in one.
class RotationScheme {
 public:
  RotationScheme() = default;
  RotationScheme(const RotationScheme&) = delete;
  RotationScheme& operator=(const RotationScheme&) = delete;
  virtual ~RotationScheme() = default;

  virtual SchemeDescription description() const noexcept = 0;

  /// Advances `state` by one step. On entry it is the state at the start of the step, before the solver's
  /// change; on return its members agree as RotationState says. May produce non-finite values: the caller
  /// then keeps the last finite state and reports the body as diverged.
  virtual void step(const StepInput& input, RotationState& state) const noexcept = 0;

  /// The same, for the caller that holds a memory for each body. It is for shortcuts only: the result is that
  /// of step, up to rounding.
  virtual void step_with_memory(const StepInput& input, RotationState& state,
                                SchemeMemory& /*memory*/) const noexcept {
    step(input, state);
  }

  /// The same for several bodies at once: each comes out as from a step_with_memory of its own, to the last
  /// bit, whatever bodies it is together with.
  virtual void step_bodies(const BodyStep* bodies, std::size_t count) const noexcept {
    for (std::size_t i = 0; i < count; ++i) {
      step_with_memory(*bodies[i].input, *bodies[i].state, *bodies[i].memory);
    }
  }
};

}  // namespace polhode
