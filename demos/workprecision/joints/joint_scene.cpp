#include "workprecision/joints/joint_scene.h"

#include <cmath>

#include "polhode/rotation_limits.h"
#include "workprecision/map_grid.h"
#include "world/body_rotation.h"

namespace polhode::demos {

namespace {

constexpr double kMass = 1.0;         // kg
constexpr double kLeastMoment = 0.1;  // kg m^2, comparable to that of the mass on the arms of the joints

// A body that is a hundred times too fast has diverged. A stable spring stays below: sampled at the ends of
// steps, its energy varies in plain Bullet by a factor of 399 at 3 rad a step.
constexpr double kGreatestEnergyGain = 1e4;

double kinetic_energy_J(const btRigidBody& body) {
  return rotation_of(body).energy() + 0.5 * kMass * from_bullet(body.getLinearVelocity()).squaredNorm();
}

}  // namespace

JointScene::JointScene(const Contender& contender, const JointStart& start)
    : start_(start), world_(contender) {
  world_.world().setGravity(btVector3(0, 0, 0));
  world_.world().getSolverInfo().m_numIterations = 30;
}

JointScene::~JointScene() {
  for (const auto& constraint : constraints_) world_.world().removeConstraint(constraint.get());
}

btRigidBody& JointScene::add_body(const Vector3& inertia_B, const Quaternion& q_WB, const Vector3& position_W,
                                  const Vector3& omega_W, const Vector3& velocity_W) {
  bodies_.push_back(std::make_unique<btRigidBody>(btScalar(kMass), nullptr, &shape_, to_bullet(inertia_B)));
  btRigidBody& body = *bodies_.back();
  body.setCenterOfMassTransform(btTransform(to_bullet(q_WB), to_bullet(position_W)));
  body.setAngularVelocity(to_bullet(omega_W));
  body.setLinearVelocity(to_bullet(velocity_W));
  body.setActivationState(DISABLE_DEACTIVATION);
  world_.set_gyroscopic_flag(body);
  constexpr int kGroup = 1;
  constexpr int kCollidesWithNothing = 0;
  world_.world().addRigidBody(&body, kGroup, kCollidesWithNothing);
  return body;
}

void JointScene::add_constraint(std::unique_ptr<btTypedConstraint> constraint) {
  constraints_.push_back(std::move(constraint));
  world_.world().addConstraint(constraints_.back().get());
}

void JointScene::step() {
  before_step();
  world_.world().stepSimulation(static_cast<btScalar>(start_.dt_s), 0);
  after_step();
}

double JointScene::energy_J() const {
  double energy_J = 0.0;
  for (const auto& body : bodies_) energy_J += kinetic_energy_J(*body);
  return energy_J;
}

bool JointScene::diverged() const {
  // The library stops a body whose scheme diverges, so its velocity does not show the divergence.
  if (world_.rotation() != nullptr && world_.rotation()->incidents() > 0) return true;
  for (const auto& body : bodies_) {
    if (!within_limits(rotation_of(*body))) return true;
  }
  // Written so that NaN counts as diverged.
  return !(energy_J() <= kGreatestEnergyGain * reference_energy_J());
}

Vector3 JointScene::inertia_B() const {
  return kLeastMoment * moments_of(start_.inertia_ratio);
}

Vector3 JointScene::spin_axis_B() const {
  const double aside = std::sin(start_.tilt) * std::sqrt(0.5);
  return {std::cos(start_.tilt), aside, aside};
}

Quaternion JointScene::start_orientation(const Vector3& spin_axis_W) const {
  return Quaternion::FromTwoVectors(spin_axis_B(), spin_axis_W);
}

}  // namespace polhode::demos
