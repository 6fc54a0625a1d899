#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>

#include "workprecision/kernel.h"
#include "world/body_rotation.h"
#include "world/conversions.h"

namespace polhode::demos {

namespace {

// Returns what btSequentialImpulseConstraintSolver::convertBodies adds to the angular velocity.
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
class FreeRigidBody {
 public:
  explicit FreeRigidBody(const btVector3& inertia_B) : body_(btScalar(1), nullptr, nullptr, inertia_B) {}

  void place(const btQuaternion& q_WB, const btVector3& omega_W) {
    body_.setAngularVelocity(omega_W);
    body_.setCenterOfMassTransform(btTransform(q_WB));
  }

  void step(const btVector3& kick_W, btScalar dt) {
    const btVector3 change_W = kick_W + gyroscopic_change_W<mode>(body_, dt, greatest_torque_);
    body_.setAngularVelocity(body_.getAngularVelocity() + change_W);
    btTransform turned;
    body_.predictIntegratedTransform(dt, turned);
    body_.proceedToTransform(turned);
  }

  const btRigidBody& body() const { return body_; }

 private:
  btScalar greatest_torque_ = btContactSolverInfo().m_maxGyroscopicForce;
  btRigidBody body_;
};

class FreeMultibody {
 public:
  explicit FreeMultibody(const btVector3& inertia_B)
      : body_(/*n_links=*/0, btScalar(1), inertia_B, /*fixedBase=*/false, /*canSleep=*/false) {
    body_.finalizeMultiDof();
    body_.setLinearDamping(btScalar(0));
    body_.setAngularDamping(btScalar(0));
  }

  void place(const btQuaternion& q_WB, const btVector3& omega_W) {
    body_.setWorldToBaseRot(q_WB.inverse());
    body_.setBaseOmega(omega_W);
  }

  void step(const btVector3& kick_W, btScalar dt) {
    body_.setBaseOmega(body_.getBaseOmega() + kick_W);
    body_.computeAccelerationsArticulatedBodyAlgorithmMultiDof(dt, scalars_, vectors_, matrices_,
                                                               /*isConstraintPass=*/false, false, false);
    body_.stepPositionsMultiDof(dt);
  }

  const btMultiBody& body() const { return body_; }

 private:
  btMultiBody body_;
  btAlignedObjectArray<btScalar> scalars_;
  btAlignedObjectArray<btVector3> vectors_;
  btAlignedObjectArray<btMatrix3x3> matrices_;
};

template <class FreeBulletBody>
class BulletKernel final : public Kernel {
 public:
  BulletKernel(const FreeBody& body, double dt_s, Kick kick)
      : start_q_WB_(to_bullet(body.q_WB)),
        start_omega_W_(to_bullet(body.omega_W)),
        dt_(static_cast<btScalar>(dt_s)),
        free_(to_bullet(body.inertia_B)) {
    const btScalar change = kick == Kick::every_step ? static_cast<btScalar>(kKick) : btScalar(0);
    kick_W_.setValue(change, change, change);
    free_.place(start_q_WB_, start_omega_W_);
  }

  void restart() override { free_.place(start_q_WB_, start_omega_W_); }

  void run(std::int64_t steps) override {
    for (std::int64_t step = 0; step < steps; ++step) free_.step(kick_W_, dt_);
  }

  RotationState state() const override { return rotation_of(free_.body()); }
  Vector3 inertia_B() const override { return inertia_of(free_.body()); }
  double dt_s() const override { return static_cast<double>(dt_); }

 private:
  btQuaternion start_q_WB_;
  btVector3 start_omega_W_;
  btVector3 kick_W_;
  btScalar dt_;
  FreeBulletBody free_;
};

}  // namespace

std::unique_ptr<Kernel> make_bullet_kernel(BulletMode mode, const FreeBody& body, double dt_s, Kick kick) {
  switch (mode) {
    case BulletMode::explicit_force:
      return std::make_unique<BulletKernel<FreeRigidBody<BulletMode::explicit_force>>>(body, dt_s, kick);
    case BulletMode::implicit_world:
      return std::make_unique<BulletKernel<FreeRigidBody<BulletMode::implicit_world>>>(body, dt_s, kick);
    case BulletMode::implicit_body:
      return std::make_unique<BulletKernel<FreeRigidBody<BulletMode::implicit_body>>>(body, dt_s, kick);
    case BulletMode::none:
      break;
  }
  return std::make_unique<BulletKernel<FreeRigidBody<BulletMode::none>>>(body, dt_s, kick);
}

std::unique_ptr<Kernel> make_multibody_kernel(const FreeBody& body, double dt_s, Kick kick) {
  return std::make_unique<BulletKernel<FreeMultibody>>(body, dt_s, kick);
}

}  // namespace polhode::demos
