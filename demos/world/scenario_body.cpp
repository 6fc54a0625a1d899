#include "world/scenario_body.h"

#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>

#include <stdexcept>

#include "scenario/start_motion.h"
#include "world/body_rotation.h"
#include "world/body_shape.h"
#include "world/bullet_rotors.h"
#include "world/conversions.h"

namespace polhode::demos {

namespace {

void set_materials(btCollisionObject& object, const Body& description) {
  object.setFriction(static_cast<btScalar>(description.friction));
  object.setRestitution(static_cast<btScalar>(description.restitution));
}

class RigidScenarioBody final : public ScenarioBody {
 public:
  RigidScenarioBody(ContenderWorld& world, const Body& description)
      : world_(world.world()),
        shape_(make_shape(description)),
        wheels_(world.rotation() == nullptr ? wheels_for(description.drive, shape_.inertia_B)
                                            : std::vector<Wheel>()),
        body_(static_cast<btScalar>((1.0 - kWheelMass * static_cast<double>(wheels_.size())) *
                                    description.mass),
              nullptr, shape_.shape.get(), to_bullet(shape_.inertia_B - inertia_in_wheels_B())) {
    const StartMotion start = start_motion(description, shape_.inertia_B);
    body_.setCenterOfMassTransform(
        btTransform(to_bullet(description.q_WB), to_bullet(description.position_W)));
    body_.setAngularVelocity(to_bullet(start.omega_W));
    body_.setLinearVelocity(to_bullet(start.velocity_W));
    set_materials(body_, description);
    body_.setDamping(static_cast<btScalar>(description.damping.linear),
                     static_cast<btScalar>(description.damping.angular));
    body_.setActivationState(DISABLE_DEACTIVATION);
    world.set_gyroscopic_flag(body_);
    world_.addRigidBody(&body_);
    if (!wheels_.empty()) rotors_ = std::make_unique<BulletRotors>(world, body_, description, wheels_);
  }

  ~RigidScenarioBody() override {
    rotors_.reset();
    if (constraint_) world_.removeConstraint(constraint_.get());
    world_.removeRigidBody(&body_);
  }

  btCollisionObject& object() override { return body_; }

  RotationState rotation() const override {
    RotationState state = rotation_of(body_);
    if (rotors_ == nullptr) return state;
    state.L_W += rotors_->angular_momentum_W();
    state.rotor_momentum_B = rotors_->momentum_B();
    return state;
  }

  Vector3 velocity_W() const override { return from_bullet(body_.getLinearVelocity()); }
  Vector3 inertia_B() const override { return inertia_of(body_) + inertia_in_wheels_B(); }
  void apply_torque(const Vector3& torque_W) override { body_.applyTorque(to_bullet(torque_W)); }

  void apply_acceleration(const Vector3& acceleration_W) override {
    body_.applyCentralForce(body_.getMass() * to_bullet(acceleration_W));
    if (rotors_ != nullptr) rotors_->apply_acceleration(acceleration_W);
  }

  void apply_rotor_torque(const Vector3& torque_B) override {
    if (rotors_ != nullptr) rotors_->apply_torque(torque_B);
  }

  void pin(const Vector3& pivot_B) override {
    constraint_ = std::make_unique<btPoint2PointConstraint>(body_, to_bullet(pivot_B));
    world_.addConstraint(constraint_.get());
  }

 private:
  Vector3 inertia_in_wheels_B() const {
    Vector3 sum_B = Vector3::Zero();
    for (const Wheel& wheel : wheels_) sum_B += wheel.transverse_inertia_B();
    return sum_B;
  }

  btDiscreteDynamicsWorld& world_;
  BodyShape shape_;
  std::vector<Wheel> wheels_;  ///< if Bullet rotates the body and the body has rotors
  btRigidBody body_;
  std::unique_ptr<BulletRotors> rotors_;
  std::unique_ptr<btPoint2PointConstraint> constraint_;
};

class MultibodyScenarioBody final : public ScenarioBody {
 public:
  MultibodyScenarioBody(btMultiBodyDynamicsWorld& world, const Body& description)
      : world_(world),
        shape_(make_shape(description)),
        multibody_(/*n_links=*/0, static_cast<btScalar>(description.mass), to_bullet(shape_.inertia_B),
                   /*fixedBase=*/false, /*canSleep=*/false),
        collider_(&multibody_, /*link=*/-1) {
    const StartMotion start = start_motion(description, shape_.inertia_B);
    multibody_.finalizeMultiDof();
    multibody_.setBasePos(to_bullet(description.position_W));
    multibody_.setWorldToBaseRot(to_bullet(description.q_WB).inverse());
    multibody_.setBaseOmega(to_bullet(start.omega_W));
    multibody_.setBaseVel(to_bullet(start.velocity_W));
    multibody_.setLinearDamping(static_cast<btScalar>(description.damping.linear));
    multibody_.setAngularDamping(static_cast<btScalar>(description.damping.angular));
    collider_.setCollisionShape(shape_.shape.get());
    collider_.setWorldTransform(multibody_.getBaseWorldTransform());
    set_materials(collider_, description);
    multibody_.setBaseCollider(&collider_);
    // Without a group it would be filtered like a static object.
    world_.addCollisionObject(&collider_, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
    world_.addMultiBody(&multibody_);
  }

  ~MultibodyScenarioBody() override {
    if (constraint_) world_.removeMultiBodyConstraint(constraint_.get());
    world_.removeMultiBody(&multibody_);
    world_.removeCollisionObject(&collider_);
  }

  btCollisionObject& object() override { return collider_; }
  RotationState rotation() const override { return rotation_of(multibody_); }
  Vector3 velocity_W() const override { return from_bullet(multibody_.getBaseVel()); }
  Vector3 inertia_B() const override { return inertia_of(multibody_); }
  void apply_torque(const Vector3& torque_W) override { multibody_.addBaseTorque(to_bullet(torque_W)); }

  void apply_acceleration(const Vector3& acceleration_W) override {
    multibody_.addBaseForce(multibody_.getBaseMass() * to_bullet(acceleration_W));
  }

  void apply_rotor_torque(const Vector3& /*torque_B*/) override {
    throw std::logic_error("a multibody has no rotors here");
  }

  void pin(const Vector3& pivot_B) override {
    btRigidBody* const the_world = nullptr;
    const btVector3 pivot_W = multibody_.getBaseWorldTransform() * to_bullet(pivot_B);
    constraint_ = std::make_unique<btMultiBodyPoint2Point>(&multibody_, /*link=*/-1, the_world,
                                                           to_bullet(pivot_B), pivot_W);
    // The constraint of a rigid body has no limit.
    constraint_->setMaxAppliedImpulse(SIMD_INFINITY);
    world_.addMultiBodyConstraint(constraint_.get());
  }

 private:
  btMultiBodyDynamicsWorld& world_;
  BodyShape shape_;
  btMultiBody multibody_;
  btMultiBodyLinkCollider collider_;
  std::unique_ptr<btMultiBodyPoint2Point> constraint_;
};

}  // namespace

std::unique_ptr<ScenarioBody> make_scenario_body(ContenderWorld& world, const Body& description) {
  if (btMultiBodyDynamicsWorld* multibodies = world.multibody_world()) {
    return std::make_unique<MultibodyScenarioBody>(*multibodies, description);
  }
  return std::make_unique<RigidScenarioBody>(world, description);
}

}  // namespace polhode::demos
