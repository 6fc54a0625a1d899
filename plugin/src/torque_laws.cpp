#include "polhode/torque_laws.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "polhode/rotation_math.h"

namespace polhode {

namespace {

std::string text(double number) {
  return std::to_string(number);
}

std::string text(const Vector3& v) {
  return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
}

void require(bool is_valid, const std::string& name, const std::string& value, const std::string& valid) {
  if (!is_valid) throw std::invalid_argument(name + " is " + value + ": valid is " + valid);
}

void require_finite(const Vector3& v, const std::string& name) {
  require(v.allFinite(), name, text(v), "three finite numbers");
}

}  // namespace

std::string_view to_string(TorqueLawOrder order) {
  return order == TorqueLawOrder::four ? "four" : "two";
}

TorqueLaw gravity_gradient(double mu, const Vector3& centre_W) {
  require(std::isfinite(mu) && mu > 0.0, "the gravitational parameter", text(mu), "a finite number above 0");
  require_finite(centre_W, "the planet's centre");
  return [mu, centre_W](const TorqueLawInput& motion) {
    const Vector3 r_W = motion.position_W - centre_W;
    const double distance = r_W.norm();
    const Vector3 u_B = motion.q_WB.conjugate() * (r_W / distance);
    const double strength = 3.0 * mu / (distance * distance * distance);
    return BodyTorque{strength * u_B.cross(motion.inertia_B.cwiseProduct(u_B))};
  };
}

TorqueLaw magnetic_dipole(const Vector3& dipole_B, const Vector3& field_W) {
  require_finite(field_W, "the magnetic field");
  return magnetic_dipole_in_field(dipole_B, [field_W](const TorqueLawInput&) { return field_W; });
}

TorqueLaw magnetic_dipole_in_field(const Vector3& dipole_B,
                                   std::function<Vector3(const TorqueLawInput&)> field_W) {
  require_finite(dipole_B, "the magnetic dipole");
  if (field_W == nullptr) throw std::invalid_argument("the magnetic field is an empty function");
  return [dipole_B, field_W = std::move(field_W)](const TorqueLawInput& motion) {
    return WorldTorque{(motion.q_WB * dipole_B).cross(field_W(motion))};
  };
}

TorqueLaw orientation_spring(const Quaternion& target_WB, double stiffness) {
  const double length = target_WB.norm();
  require(std::isfinite(length) && length > 0.0, "the length of the target orientation", text(length),
          "a finite number above 0");
  require(std::isfinite(stiffness) && stiffness >= 0.0, "the stiffness", text(stiffness),
          "a finite number of at least 0");
  return [target_WB = target_WB.normalized(), stiffness](const TorqueLawInput& motion) {
    return WorldTorque{-stiffness * logarithm(motion.q_WB * target_WB.conjugate())};
  };
}

TorqueLaw rate_damping(const Vector3& coefficients_B) {
  require(coefficients_B.allFinite() && coefficients_B.minCoeff() >= 0.0, "the damping coefficients",
          text(coefficients_B), "three finite numbers of at least 0");
  return [coefficients_B](const TorqueLawInput& motion) {
    return BodyTorque{-coefficients_B.cwiseProduct(motion.omega_B())};
  };
}

TorqueLaw rate_damping(double coefficient) {
  return rate_damping(Vector3(Vector3::Constant(coefficient)));
}

TorqueLaw internal_damping(double moment, double coefficient) {
  require(std::isfinite(moment) && moment > 0.0, "the damper's moment", text(moment),
          "a finite number above 0");
  require(std::isfinite(coefficient) && coefficient >= 0.0, "the damping coefficient", text(coefficient),
          "a finite number of at least 0");
  return [moment, coefficient](const TorqueLawInput& motion) {
    return RotorTorque{coefficient * (motion.omega_B() - motion.rotor_momentum_B / moment)};
  };
}

}  // namespace polhode
