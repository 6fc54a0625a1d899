#include "world/bullet_rotors.h"

#include <algorithm>

#include "polhode/rotation_math.h"
#include "world/conversions.h"

namespace polhode::demos {

namespace {

// The rest stays with the body, which needs some inertia about each axis.
constexpr double kPartInWheels = 0.8;

bool needs_wheel(const Drive& drive, int axis) {
  if (drive.law && std::holds_alternative<InternalDamping>(*drive.law)) return true;
  return drive.rotor_momentum_B[axis] != 0.0 ||
         std::any_of(drive.motor_torques.begin(), drive.motor_torques.end(),
                     [axis](const MotorTorque& torque) { return torque.torque_B[axis] != 0.0; });
}

Wheel wheel_about(int axis, double largest_transverse_moment, const Drive& drive) {
  const InternalDamping* const damping = drive.law ? std::get_if<InternalDamping>(&*drive.law) : nullptr;
  const double axial_moment = damping != nullptr ? damping->moment : 2.0 * largest_transverse_moment;
  return {axis, axial_moment, std::min(0.5 * axial_moment, largest_transverse_moment)};
}

Vector3 axis_W(const btRigidBody& body, int axis) {
  return from_bullet(body.getWorldTransform().getBasis().getColumn(axis));
}

}  // namespace

Vector3 Wheel::inertia_B() const {
  Vector3 inertia_B = transverse_inertia_B();
  inertia_B[axis] = axial_moment;
  return inertia_B;
}

Vector3 Wheel::transverse_inertia_B() const {
  Vector3 inertia_B = Vector3::Constant(transverse_moment);
  inertia_B[axis] = 0.0;
  return inertia_B;
}

std::vector<Wheel> wheels_for(const Drive& drive, const Vector3& inertia_B) {
  std::vector<int> axes;
  for (int axis = 0; axis < 3; ++axis) {
    if (needs_wheel(drive, axis)) axes.push_back(axis);
  }
  std::vector<Wheel> wheels;
  for (const int axis : axes) {
    const double smaller = std::min(inertia_B[(axis + 1) % 3], inertia_B[(axis + 2) % 3]);
    wheels.push_back(wheel_about(axis, kPartInWheels / static_cast<double>(axes.size()) * smaller, drive));
  }
  return wheels;
}

BulletRotors::BulletRotors(ContenderWorld& world, btRigidBody& body, const Body& description,
                           const std::vector<Wheel>& wheels)
    : world_(world.world()), body_(body) {
  for (const Wheel& wheel : wheels) wheels_.push_back(mounted(world, wheel, description));
}

BulletRotors::~BulletRotors() {
  for (const MountedWheel& each : wheels_) {
    world_.removeConstraint(each.hinge.get());
    world_.removeRigidBody(each.body.get());
  }
}

BulletRotors::MountedWheel BulletRotors::mounted(ContenderWorld& world, const Wheel& wheel,
                                                 const Body& description) {
  auto body = std::make_unique<btRigidBody>(static_cast<btScalar>(kWheelMass * description.mass), nullptr,
                                            &shape_, to_bullet(wheel.inertia_B()));
  body->setCenterOfMassTransform(body_.getCenterOfMassTransform());
  body->setLinearVelocity(body_.getLinearVelocity());
  const Vector3 omega_W = from_bullet(body_.getAngularVelocity());
  const Vector3 wheel_axis_W = axis_W(body_, wheel.axis);
  const double spin = description.drive.rotor_momentum_B[wheel.axis] / wheel.axial_moment;
  body->setAngularVelocity(to_bullet(omega_W + (spin - omega_W.dot(wheel_axis_W)) * wheel_axis_W));
  body->setDamping(static_cast<btScalar>(description.damping.linear), 0);
  body->setActivationState(DISABLE_DEACTIVATION);
  world.set_gyroscopic_flag(*body);
  world_.addRigidBody(body.get(), /*group=*/0, /*mask=*/0);

  const btVector3 centre(0, 0, 0);
  const btVector3 axis_B = to_bullet(Vector3::Unit(wheel.axis));
  auto hinge = std::make_unique<btHingeConstraint>(body_, *body, centre, centre, axis_B, axis_B);
  world_.addConstraint(hinge.get(), /*disableCollisionsBetweenLinkedBodies=*/true);
  return {wheel, std::move(body), std::move(hinge)};
}

Vector3 BulletRotors::momentum_B() const {
  Vector3 momentum_B = Vector3::Zero();
  for (const auto& [wheel, body, hinge] : wheels_) {
    momentum_B[wheel.axis] =
        wheel.axial_moment * axis_W(*body, wheel.axis).dot(from_bullet(body->getAngularVelocity()));
  }
  return momentum_B;
}

Vector3 BulletRotors::angular_momentum_W() const {
  Vector3 sum_W = Vector3::Zero();
  for (const auto& [wheel, body, hinge] : wheels_) {
    sum_W += polhode::angular_momentum_W(from_bullet(body->getWorldTransform().getBasis()), wheel.inertia_B(),
                                         from_bullet(body->getAngularVelocity()));
  }
  return sum_W;
}

void BulletRotors::apply_torque(const Vector3& torque_B) {
  for (const auto& [wheel, body, hinge] : wheels_) {
    const btVector3 torque_W = to_bullet(torque_B[wheel.axis] * axis_W(body_, wheel.axis));
    body->applyTorque(torque_W);
    body_.applyTorque(-torque_W);
  }
}

void BulletRotors::apply_acceleration(const Vector3& acceleration_W) {
  for (const auto& [wheel, body, hinge] : wheels_) {
    body->applyCentralForce(body->getMass() * to_bullet(acceleration_W));
  }
}

}  // namespace polhode::demos
