#include "world/scenario_world.h"

#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>

#include <utility>

#include "polhode/rotation_limits.h"
#include "scenario/start_motion.h"
#include "world/body_rotation.h"
#include "world/conversions.h"

namespace polhode::demos {

ScenarioWorld::ScenarioWorld(const Scenario& scenario, const Contender& contender)
    : scenario_(scenario), world_(contender) {
  world().setGravity(to_bullet(scenario_.gravity_W));
  world().getSolverInfo().m_numIterations = scenario_.solver_iterations;
  add_body(scenario.body);
  for (const Body& other : scenario.others) add_body(other);
  if (scenario.ground) add_ground(*scenario.ground);
  if (scenario.constraint) add_constraint(*scenario.constraint);
}

ScenarioWorld::~ScenarioWorld() {
  if (constraint_) world().removeConstraint(constraint_.get());
}

btRigidBody& ScenarioWorld::keep_body(BodyShape shape, btScalar mass) {
  shapes_.push_back(std::move(shape));
  bodies_.push_back(std::make_unique<btRigidBody>(mass, nullptr, shapes_.back().shape.get(),
                                                  to_bullet(shapes_.back().inertia_B)));
  return *bodies_.back();
}

void ScenarioWorld::add_body(const Body& description) {
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
  world_.set_gyroscopic_flag(body);
  world().addRigidBody(&body);
}

void ScenarioWorld::add_ground(const Ground& ground) {
  BodyShape plane;
  plane.shape =
      std::make_unique<btStaticPlaneShape>(to_bullet(ground.normal_W), static_cast<btScalar>(ground.height));
  plane.inertia_B = Vector3::Zero();
  btRigidBody& body = keep_body(std::move(plane), btScalar(0));
  body.setFriction(static_cast<btScalar>(ground.friction));
  body.setRestitution(static_cast<btScalar>(ground.restitution));
  world().addRigidBody(&body);
}

void ScenarioWorld::add_constraint(const PointToPoint& constraint) {
  constraint_ = std::make_unique<btPoint2PointConstraint>(*bodies_.front(), to_bullet(constraint.pivot_B));
  world().addConstraint(constraint_.get());
}

void ScenarioWorld::step() {
  // Bullet clears the torques after each step.
  bodies_.front()->applyTorque(to_bullet(scenario_.torque_W));
  world().stepSimulation(static_cast<btScalar>(scenario_.dt), 0);
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
  if (const RotationControl* control = world_.rotation()) {
    const BodyRotation rotation = control->rotation_of(body());
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
