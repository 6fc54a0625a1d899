#include "world/scenario_world.h"

#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include "polhode/rotation_limits.h"
#include "world/conversions.h"

namespace polhode::demos {

ScenarioWorld::ScenarioWorld(const Scenario& scenario, const Contender& contender)
    : scenario_(scenario), world_(contender) {
  require_can_run(contender, scenario);
  world().setGravity(to_bullet(scenario_.gravity_W));
  world().getSolverInfo().m_numIterations = scenario_.solver_iterations;
  add_body(scenario.body);
  for (const Body& other : scenario.others) add_body(other);
  if (scenario.ground) add_ground(*scenario.ground);
  if (scenario.constraint) bodies_.front()->pin(scenario.constraint->pivot_B);
}

void ScenarioWorld::add_body(const Body& description) {
  bodies_.push_back(make_scenario_body(world_, description));
  drivers_.emplace_back(*bodies_.back(), description.drive, world_.rotation());
}

void ScenarioWorld::add_ground(const Ground& ground) {
  plane_.shape =
      std::make_unique<btStaticPlaneShape>(to_bullet(ground.normal_W), static_cast<btScalar>(ground.height));
  ground_ = std::make_unique<btRigidBody>(btScalar(0), nullptr, plane_.shape.get());
  ground_->setFriction(static_cast<btScalar>(ground.friction));
  ground_->setRestitution(static_cast<btScalar>(ground.restitution));
  world().addRigidBody(ground_.get());
}

void ScenarioWorld::step() {
  bodies_.front()->apply_torque(scenario_.torque_W);
  for (Driver& driver : drivers_)
    driver.before_step(static_cast<double>(steps_) * scenario_.dt, scenario_.dt);
  world().stepSimulation(static_cast<btScalar>(scenario_.dt), 0);
  ++steps_;
}

std::optional<Sample> ScenarioWorld::sample() const {
  const std::optional<RotationState> state = rotation();
  if (!state) return std::nullopt;
  Sample sample{steps_, static_cast<double>(steps_) * scenario_.dt, *state,
                from_bullet(body().getWorldTransform().getOrigin()), energy_J(*state)};
  if (!sample.all_finite()) return std::nullopt;
  return sample;
}

std::optional<RotationState> ScenarioWorld::rotation() const {
  if (const RotationControl* control = world_.rotation()) {
    const BodyRotation rotation = control->rotation_of(*btRigidBody::upcast(&body()));
    return rotation.diverged ? std::nullopt : std::optional(rotation.state);
  }
  const RotationState state = bodies_.front()->rotation();
  const bool sound = state.all_finite() && state.omega_W.norm() <= kMaximumAngularSpeed;
  return sound ? std::optional(state) : std::nullopt;
}

double ScenarioWorld::energy_J(const RotationState& state) const {
  const double mass = scenario_.body.mass;
  const Vector3 velocity_W = bodies_.front()->velocity_W();
  const Vector3 position_W = from_bullet(body().getWorldTransform().getOrigin());
  const double energy_J =
      state.energy() + 0.5 * mass * velocity_W.squaredNorm() - mass * scenario_.gravity_W.dot(position_W);
  const std::optional<ChosenLaw>& law = scenario_.body.drive.law;
  return law ? energy_J + potential_J(*law, {state.q_WB, position_W, inertia_B(), mass}) : energy_J;
}

}  // namespace polhode::demos
