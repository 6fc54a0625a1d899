#pragma once

#include <cstdint>
#include <memory>

#include "polhode/rotation_state.h"

/// Exactly known motions, for testing schemes.
namespace polhode::oracle {

/// The torque-free rotation of any rigid body, with its orientation, in closed form and 50 decimal digits.
/// The formulas are in free_top.cpp. The cost does not depend on the time: nothing is integrated.
class FreeTop {
 public:
  /// Takes principal moments in kg m^2, each above 0 (they may violate the triangle inequality); the
  /// orientation at t = 0, of any length but 0; and the angular momentum in world axes. All are treated as
  /// exact numbers.
  /// @throws std::invalid_argument for anything else.
  FreeTop(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& L_W);
  ~FreeTop();
  FreeTop(FreeTop&&) noexcept;
  FreeTop& operator=(FreeTop&&) noexcept;

  Quaternion q_WB(double t_s) const;
  Vector3 L_B(double t_s) const;
  RotationState at(double t_s) const;

  /// Returns the angle between an orientation (of any length) and the exact one, rad. Computed in 50 digits,
  /// so that even an angle far below double rounding is accurate to all digits.
  double attitude_error(const Quaternion& q_WB, double t_s) const;

  /// Returns the error at the time steps * dt_s, which is not rounded to a double (at 10 rad/s that would
  /// cost 1e-12 rad within an hour). About fifteen times faster than attitude_error (2 to 4 us instead of 30
  /// to 60 us): only the phases, which grow with time, use 50 digits; their periodic functions use `long
  /// double`. Differs from attitude_error by less than 1e-18 rad where `long double` has a 64-bit
  /// significand.
  double attitude_error_after(const Quaternion& q_WB, std::int64_t steps, double dt_s) const;

 private:
  struct Motion;
  std::unique_ptr<const Motion> motion_;
};

}  // namespace polhode::oracle
