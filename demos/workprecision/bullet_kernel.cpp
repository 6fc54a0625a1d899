#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "workprecision/kernel.h"
#include "world/body_rotation.h"
#include "world/conversions.h"

namespace polhode::demos {

namespace {

// btSequentialImpulseConstraintSolver::convertBodies adds this to the angular velocity.
template <BulletMode mode>
btVector3 gyroscopic_change_W(const btRigidBody& body, btScalar dt, btScalar greatest_torque) {
  if constexpr (mode == BulletMode::explicit_force) {
    return -(body.computeGyroscopicForceExplicit(greatest_torque) * body.getInvInertiaTensorWorld() * dt);
  } else if constexpr (mode == BulletMode::implicit_world) {
    return body.computeGyroscopicImpulseImplicit_World(dt);
  } else if constexpr (mode == BulletMode::implicit_body) {
    return body.computeGyroscopicImpulseImplicit_Body(dt);
  } else {
    return {btScalar(0), btScalar(0), btScalar(0)};
  }
}

template <BulletMode mode>
class BulletKernel final : public Kernel {
 public:
  BulletKernel(const FreeBody& body, double dt_s, Kick kick)
      : start_(to_bullet(body.q_WB)),
        start_omega_W_(to_bullet(body.omega_W)),
        dt_(static_cast<btScalar>(dt_s)),
        body_(btScalar(1), nullptr, nullptr, to_bullet(body.inertia_B)) {
    const btScalar change = kick == Kick::every_step ? static_cast<btScalar>(kKick) : btScalar(0);
    kick_.setValue(change, change, change);
    restart_now();
  }

  void restart() override { restart_now(); }

  void run(std::int64_t steps) override {
    for (std::int64_t step = 0; step < steps; ++step) {
      const btVector3 change_W = kick_ + gyroscopic_change_W<mode>(body_, dt_, greatest_torque_);
      body_.setAngularVelocity(body_.getAngularVelocity() + change_W);
      btTransform turned;
      body_.predictIntegratedTransform(dt_, turned);
      body_.proceedToTransform(turned);
    }
  }

  RotationState state() const override { return rotation_of(body_); }
  Vector3 inertia_B() const override { return inertia_of(body_); }
  double dt_s() const override { return static_cast<double>(dt_); }

 private:
  void restart_now() {
    body_.setAngularVelocity(start_omega_W_);
    body_.setCenterOfMassTransform(start_);
  }

  btTransform start_;
  btVector3 start_omega_W_;
  btVector3 kick_;
  btScalar dt_;
  btScalar greatest_torque_ = btContactSolverInfo().m_maxGyroscopicForce;
  btRigidBody body_;
};

}  // namespace

std::unique_ptr<Kernel> make_bullet_kernel(BulletMode mode, const FreeBody& body, double dt_s, Kick kick) {
  switch (mode) {
    case BulletMode::explicit_force:
      return std::make_unique<BulletKernel<BulletMode::explicit_force>>(body, dt_s, kick);
    case BulletMode::implicit_world:
      return std::make_unique<BulletKernel<BulletMode::implicit_world>>(body, dt_s, kick);
    case BulletMode::implicit_body:
      return std::make_unique<BulletKernel<BulletMode::implicit_body>>(body, dt_s, kick);
    case BulletMode::none:
      break;
  }
  return std::make_unique<BulletKernel<BulletMode::none>>(body, dt_s, kick);
}

}  // namespace polhode::demos
