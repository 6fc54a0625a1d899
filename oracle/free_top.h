#pragma once

#include <cstdint>
#include <memory>

#include "polhode/rotation_state.h"

/// Motions that are known exactly, to hold schemes against.
namespace polhode::oracle {

/// The torque-free rotation of any rigid body in closed form, its orientation included, in 50 decimal digits
/// (free_top.cpp has the formulas). An answer costs the same at any time: nothing is integrated.
class FreeTop {
 public:
  /// Principal moments in kg m^2, each above 0 (they may violate the triangle inequality); the orientation at
  /// t = 0, of any length but 0; the angular momentum in world axes. All are taken for exact numbers.
  /// @throws std::invalid_argument for anything else.
  FreeTop(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& L_W);
  ~FreeTop();
  FreeTop(FreeTop&&) noexcept;
  FreeTop& operator=(FreeTop&&) noexcept;

  Quaternion q_WB(double t_s) const;
  Vector3 L_B(double t_s) const;
  RotationState at(double t_s) const;

  /// The angle of the rotation between an orientation (of any length) and the true one, rad. Their difference
  /// is formed in 50 digits, so that an angle far below the rounding of a double has all its digits too.
  double attitude_error(const Quaternion& q_WB, double t_s) const;

  /// The same at the time steps * dt_s, which is not rounded to a double (in an hour at 10 rad/s that would
  /// cost 1e-12 rad), and some fifteen times cheaper (2 to 4 us for 30 to 60 us): 50 digits for the phases,
  /// which grow with time, `long double` for what is periodic in them. It differs from the former by less
  /// than 1e-18 rad where `long double` has 64 bits.
  double attitude_error_after(const Quaternion& q_WB, std::int64_t steps, double dt_s) const;

 private:
  struct Motion;
  std::unique_ptr<const Motion> motion_;
};

}  // namespace polhode::oracle
