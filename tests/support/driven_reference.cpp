#include "support/driven_reference.h"

#include "polhode/rotation_math.h"

namespace polhode::testing {

namespace {

// Rows: q_WB (x, y, z, w), L_W, h.
using Numbers = Eigen::Matrix<double, 10, 1>;

class Equations {
 public:
  Equations(const Vector3& inertia_B, const DrivenStart& place, const TorqueLaw& law)
      : inertia_B_(inertia_B), place_(place), law_(law) {}

  Numbers rate(double t, const Numbers& y) const {
    // The stages of the method are not normalised.
    const Quaternion q_WB = Quaternion(y.head<4>()).normalized();
    const Matrix3 R_WB = q_WB.toRotationMatrix();
    const Vector3 L_W = y.segment<3>(4);
    const Vector3 rotor_B = y.tail<3>();
    const Vector3 omega_B = (R_WB.transpose() * L_W - rotor_B).cwiseQuotient(inertia_B_);
    const Torque torque =
        law_({place_.time_s + t, q_WB, R_WB * omega_B, place_.position_W + t * place_.velocity_W,
              place_.velocity_W, inertia_B_, rotor_B});
    Numbers rate;
    const Quaternion turn = Quaternion(y.head<4>()) * Quaternion(0.0, omega_B.x(), omega_B.y(), omega_B.z());
    rate << 0.5 * turn.coeffs(), torque.world_W + R_WB * torque.body_B, torque.rotor_B;
    return rate;
  }

 private:
  const Vector3& inertia_B_;
  const DrivenStart& place_;
  const TorqueLaw& law_;
};

}  // namespace

RotationState integrate_driven(const Vector3& inertia_B, const RotationState& start, const DrivenStart& place,
                               const TorqueLaw& law, double duration, int steps) {
  const Equations equations(inertia_B, place, law);
  const double dt = duration / steps;
  Numbers y;
  y << start.q_WB.coeffs(), start.L_W, start.rotor_momentum_B;
  for (int i = 0; i < steps; ++i) {
    const double t = i * dt;
    const Numbers k1 = equations.rate(t, y);
    const Numbers k2 = equations.rate(t + 0.5 * dt, y + 0.5 * dt * k1);
    const Numbers k3 = equations.rate(t + 0.5 * dt, y + 0.5 * dt * k2);
    const Numbers k4 = equations.rate(t + dt, y + dt * k3);
    y += dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    y.head<4>().normalize();
  }
  RotationState end;
  end.rotor_momentum_B = y.tail<3>();
  set_orientation(end, Quaternion(Eigen::Vector4d(y.head<4>())));
  set_angular_momentum(end, inertia_B, y.segment<3>(4));
  return end;
}

}  // namespace polhode::testing
