#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "polhode/rotation_state.h"

namespace polhode {

/// Grades how well a scheme keeps a quantity of free motion.
enum class Conservation {
  exact,    ///< to rounding, for ever
  bounded,  ///< the error oscillates and does not grow with time
  lost,     ///< the error grows with time
};

/// "exactly", "boundedly" or "not".
std::string_view to_string(Conservation conservation);

/// Returns the order as text: "2", or "exact" for a motion without error.
std::string order_text(std::optional<int> order);

/// The constant angular velocity that turns the body in a step of a scheme. Bullet's solver is given it for a
/// body with contacts or joints.
enum class TurnVelocity {
  /// I_t^-1 L at the orientation of the start, after the kick. The scheme carries L.
  start,
  /// The velocity at the end of the step. The scheme carries omega and adds a gyroscopic change.
  end,
  /// None: the body follows the curved free motion. The solver is given the mean velocity, which takes the
  /// orientation of the start to that of the end. The scheme carries L.
  mean,
};

/// "start", "end" or "mean".
std::string_view to_string(TurnVelocity turn_velocity);

/// Describes a scheme in its own words. The texts are valid as long as the scheme is: literals, or strings that it holds.
struct SchemeDescription {
  std::string_view name;        ///< as in `set_scheme("name")`, whole words in snake_case
  std::string_view summary;     ///< one line
  std::string_view source;      ///< paper or text, with equation numbers
  std::string_view fails_when;  ///< one line
  /// The order of convergence of the orientation in dt, in free motion; none if the only error is rounding.
  std::optional<int> order = 1;
  Conservation energy = Conservation::lost;            ///< rotational kinetic energy
  Conservation angular_momentum = Conservation::lost;  ///< the vector L_W
  Conservation rotation = Conservation::exact;         ///< R_WB stays a rotation: det R_WB = 1
  TurnVelocity turn_velocity = TurnVelocity::mean;
  bool takes_rotors = false;  ///< steps bodies whose RotationState::rotor_momentum_B is not 0
};

/// The input of one step, besides the state at its start.
struct StepInput {
  Vector3 inertia_B;  ///< principal moments, kg m^2, each > 0; may violate the triangle inequality
  /// Kick: the change of velocity that torques and impulses make at the start of the step, rad/s.
  Vector3 delta_omega_W;
  double dt;  ///< length of the step, s; may be negative
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

  /// Advances `state` by one step: the kick, then free motion for dt. On entry `state` is the state before
  /// the kick; on return its members agree as RotationState says. May produce non-finite values: the caller
  /// then keeps the last finite state and reports the body as diverged.
  virtual void step(const StepInput& input, RotationState& state) const noexcept = 0;

  /// Turns the orientation (q_WB and R_WB, nothing else) at the constant velocity omega_W for dt, as the
  /// scheme's own step turns. Default: the exponential map.
  virtual void turn(const Vector3& omega_W, double dt, RotationState& state) const noexcept;
};

}  // namespace polhode
