#include "world/scenario_world.h"

#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>

#include <utility>

#include "polhode/bullet/rotation_world.h"
#include "polhode/rotation_limits.h"
#include "scenario/start_motion.h"
#include "world/body_rotation.h"
#include "world/conversions.h"

namespace polhode::demos {

namespace {

int bullet_flags(BulletMode mode) {
  switch (mode) {
    case BulletMode::explicit_force:
      return BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT;
    case BulletMode::implicit_world:
      return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD;
    case BulletMode::implicit_body:
      return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;
    case BulletMode::none:
      break;
  }
  return 0;
}

}  // namespace

ScenarioWorld::ScenarioWorld(const Scenario& scenario, const Contender& contender) : scenario_(scenario) {
  make_world(contender);
  add_body(scenario.body, contender);
  for (const Body& other : scenario.others) add_body(other, contender);
  if (scenario.ground) add_ground(*scenario.ground);
  if (scenario.constraint) add_constraint(*scenario.constraint);
}

ScenarioWorld::~ScenarioWorld() {
  if (constraint_) world_->removeConstraint(constraint_.get());
}

void ScenarioWorld::make_world(const Contender& contender) {
  if (const SchemePointer* scheme = std::get_if<SchemePointer>(&contender.method)) {
    auto world = std::make_unique<RotationWorld<btDiscreteDynamicsWorld>>(&dispatcher_, &broadphase_,
                                                                          &solver_, &configuration_);
    world->rotation().set_default_scheme(*scheme);
    rotation_ = &world->rotation();
    world_ = std::move(world);
  } else {
    world_ = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_);
  }
  world_->setGravity(to_bullet(scenario_.gravity_W));
  world_->getSolverInfo().m_numIterations = scenario_.solver_iterations;
}

btRigidBody& ScenarioWorld::keep_body(BodyShape shape, btScalar mass) {
  shapes_.push_back(std::move(shape));
  bodies_.push_back(std::make_unique<btRigidBody>(mass, nullptr, shapes_.back().shape.get(),
                                                  to_bullet(shapes_.back().inertia_B)));
  return *bodies_.back();
}

void ScenarioWorld::add_body(const Body& description, const Contender& contender) {
  BodyShape shape = make_shape(description);
  const StartMotion start = start_motion(description, shape.inertia_B);
  btRigidBody& body = keep_body(std::move(shape), static_cast<btScalar>(description.mass));
  body.setCenterOfMassTransform(btTransform(to_bullet(description.q_WB), to_bullet(description.position_W)));
  body.setAngularVelocity(to_bullet(start.omega_W));
  body.setLinearVelocity(to_bullet(start.velocity_W));
  body.setFriction(static_cast<btScalar>(description.friction));
  body.setRestitution(static_cast<btScalar>(description.restitution));
  body.setDamping(static_cast<btScalar>(description.linear_damping),
                  static_cast<btScalar>(description.angular_damping));
  body.setActivationState(DISABLE_DEACTIVATION);
  if (const BulletMode* mode = std::get_if<BulletMode>(&contender.method)) body.setFlags(bullet_flags(*mode));
  world_->addRigidBody(&body);
}

void ScenarioWorld::add_ground(const Ground& ground) {
  BodyShape plane;
  plane.shape =
      std::make_unique<btStaticPlaneShape>(to_bullet(ground.normal_W), static_cast<btScalar>(ground.height));
  plane.inertia_B = Vector3::Zero();
  btRigidBody& body = keep_body(std::move(plane), btScalar(0));
  body.setFriction(static_cast<btScalar>(ground.friction));
  body.setRestitution(static_cast<btScalar>(ground.restitution));
  world_->addRigidBody(&body);
}

void ScenarioWorld::add_constraint(const PointToPoint& constraint) {
  constraint_ = std::make_unique<btPoint2PointConstraint>(*bodies_.front(), to_bullet(constraint.pivot_B));
  world_->addConstraint(constraint_.get());
}

void ScenarioWorld::step() {
  // Bullet clears the torques after each step.
  bodies_.front()->applyTorque(to_bullet(scenario_.torque_W));
  world_->stepSimulation(static_cast<btScalar>(scenario_.dt), 0);
  ++steps_;
}

std::optional<Sample> ScenarioWorld::sample() const {
  const std::optional<RotationState> state = rotation();
  if (!state) return std::nullopt;
  Sample sample{steps_, static_cast<double>(steps_) * scenario_.dt, *state,
                from_bullet(body().getCenterOfMassPosition()), energy_J(*state)};
  if (!sample.all_finite()) return std::nullopt;
  return sample;
}

std::optional<RotationState> ScenarioWorld::rotation() const {
  if (rotation_ != nullptr) {
    const BodyRotation rotation = rotation_->rotation_of(body());
    return rotation.diverged ? std::nullopt : std::optional(rotation.state);
  }
  const RotationState state = rotation_of(body());
  const bool sound = state.all_finite() && state.omega_W.norm() <= kMaximumAngularSpeed;
  return sound ? std::optional(state) : std::nullopt;
}

Vector3 ScenarioWorld::inertia_B() const {
  return inertia_of(body());
}

double ScenarioWorld::energy_J(const RotationState& state) const {
  const double mass = scenario_.body.mass;
  const Vector3 velocity_W = from_bullet(body().getLinearVelocity());
  const Vector3 position_W = from_bullet(body().getCenterOfMassPosition());
  return state.energy() + 0.5 * mass * velocity_W.squaredNorm() - mass * scenario_.gravity_W.dot(position_W);
}

}  // namespace polhode::demos
