#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "polhode/rotation_state.h"

namespace polhode {

/// How well a scheme conserves a quantity of free motion.
enum class Conservation {
  exact,    ///< up to rounding, forever
  bounded,  ///< the error oscillates without growing
  lost,     ///< the error grows with time
};

/// Returns "exactly", "boundedly" or "not".
std::string_view to_string(Conservation conservation);

/// Returns the order as text, for example "2"; "exact" if there is none.
std::string order_text(std::optional<int> order);

/// The constant angular velocity at which a scheme rotates the body in a step. For a body with contacts or
/// joints, Bullet's solver starts from this velocity.
enum class TurnVelocity {
  /// I_W^-1 L_W at the start orientation, after the kick. The scheme carries L.
  start,
  /// The velocity at the end of the step. The scheme carries omega and adds a gyroscopic change.
  end,
  /// No constant velocity: the body follows the curved free motion. The solver starts from the mean velocity,
  /// which rotates the start orientation into the end orientation. The scheme carries L.
  mean,
};

/// Returns "start", "end" or "mean".
std::string_view to_string(TurnVelocity turn_velocity);

/// Describes a scheme. The texts must stay valid as long as the scheme: literals, or strings that the scheme
/// holds.
struct SchemeDescription {
  std::string_view name;        ///< the name for `set_scheme("name")`, in snake_case
  std::string_view summary;     ///< one line
  std::string_view source;      ///< paper or textbook, with equation numbers
  std::string_view fails_when;  ///< one line
  /// Order of convergence of the orientation in dt, in free motion; empty if the only error is rounding.
  std::optional<int> order = 1;
  Conservation energy = Conservation::lost;            ///< rotational kinetic energy
  Conservation angular_momentum = Conservation::lost;  ///< the vector L_W
  Conservation rotation = Conservation::exact;         ///< R_WB stays a rotation: det R_WB = 1
  TurnVelocity turn_velocity = TurnVelocity::mean;
  bool takes_rotors = false;  ///< supports RotationState::rotor_momentum_B other than 0
};

/// The input of one step besides the state.
struct StepInput {
  Vector3 inertia_B;  ///< principal moments, kg m^2, each > 0; may violate the triangle inequality
  /// Kick: the change of velocity by torques and impulses, applied at the start of the step, rad/s.
  Vector3 delta_omega_W;
  double dt;  ///< length of the step, s; may be negative
};

/// A method that advances the rotation of a body. Stateless: one object serves any number of bodies, worlds
/// and threads. Applications derive their own schemes and use them like the built-in ones.
class RotationScheme {
 public:
  RotationScheme() = default;
  RotationScheme(const RotationScheme&) = delete;
  RotationScheme& operator=(const RotationScheme&) = delete;
  virtual ~RotationScheme() = default;

  virtual SchemeDescription description() const noexcept = 0;

  /// Advances `state` by one step: the kick, then free motion for dt. On entry `state` is the state before
  /// the kick. On return its members agree as RotationState requires. May produce values that are not finite:
  /// the caller then keeps the last finite state and reports the body as diverged.
  virtual void step(const StepInput& input, RotationState& state) const noexcept = 0;

  /// Rotates q_WB and R_WB at the constant velocity omega_W for dt, in the manner of the scheme's own step,
  /// and changes nothing else. The default is the exponential map.
  virtual void turn(const Vector3& omega_W, double dt, RotationState& state) const noexcept;
};

}  // namespace polhode
