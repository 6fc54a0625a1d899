#include "world/body_shape.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <stdexcept>

#include "scenario/start_motion.h"
#include "world/conversions.h"

namespace polhode::demos {

namespace {

BodyShape simple_shape(std::unique_ptr<btCollisionShape> shape, double mass) {
  btVector3 inertia;
  shape->calculateLocalInertia(static_cast<btScalar>(mass), inertia);
  BodyShape result;
  result.shape = std::move(shape);
  result.inertia_B = from_bullet(inertia);
  return result;
}

BodyShape bullet_shape(const Sphere& sphere, double mass) {
  return simple_shape(std::make_unique<btSphereShape>(static_cast<btScalar>(sphere.radius)), mass);
}

BodyShape bullet_shape(const Box& box, double mass) {
  return simple_shape(std::make_unique<btBoxShape>(to_bullet(box.half_extents)), mass);
}

// Adds the parts as the scenario places them, lets Bullet find the centre of mass and the principal axes, and
// then moves the parts to that frame, which is the body's.
BodyShape bullet_shape(const Compound& compound, double /*mass*/) {
  BodyShape result;
  btCompoundShape as_given;
  std::vector<btScalar> masses;
  for (const BoxPart& part : compound.parts) {
    result.children.push_back(std::make_unique<btBoxShape>(to_bullet(part.half_extents)));
    as_given.addChildShape(btTransform(btQuaternion::getIdentity(), to_bullet(part.at)),
                           result.children.back().get());
    masses.push_back(static_cast<btScalar>(part.mass));
  }
  btTransform principal;
  btVector3 inertia;
  as_given.calculatePrincipalAxisTransform(masses.data(), principal, inertia);
  auto shape = std::make_unique<btCompoundShape>();
  for (int i = 0; i < as_given.getNumChildShapes(); ++i) {
    shape->addChildShape(principal.inverse() * as_given.getChildTransform(i), as_given.getChildShape(i));
  }
  result.shape = std::move(shape);
  result.inertia_B = from_bullet(inertia);
  return result;
}

DrawnBody drawn(const btBoxShape& box, const btTransform& pose_BP) {
  const Quaternion q_BP(from_bullet(pose_BP.getBasis()));
  return {
      std::nullopt,
      {{from_bullet(box.getHalfExtentsWithMargin()), from_bullet(pose_BP.getOrigin()), q_BP.normalized()}}};
}

DrawnBody drawn(const btCompoundShape& compound) {
  DrawnBody result;
  for (int i = 0; i < compound.getNumChildShapes(); ++i) {
    const auto& box = static_cast<const btBoxShape&>(*compound.getChildShape(i));
    result.boxes.push_back(drawn(box, compound.getChildTransform(i)).boxes.front());
  }
  return result;
}

void resolve(Body& body) {
  body.inertia_B = make_shape(body).inertia_B;
  start_motion(body, *body.inertia_B);  // throws if the start cannot be run
}

}  // namespace

BodyShape make_shape(const Body& body) {
  BodyShape result =
      std::visit([&](const auto& shape) { return bullet_shape(shape, body.mass); }, body.shape);
  if (body.inertia_B) result.inertia_B = *body.inertia_B;
  const Vector3& inertia_B = result.inertia_B;
  if (!kInertiaRange.contains(inertia_B.minCoeff()) || !kInertiaRange.contains(inertia_B.maxCoeff())) {
    throw std::invalid_argument("\"shape\": its principal moments must be " + range_text(kInertiaRange) +
                                ", in kg m^2; give other sizes or masses, or \"inertia\"");
  }
  return result;
}

DrawnBody drawn_body(const Body& body) {
  if (const Sphere* sphere = std::get_if<Sphere>(&body.shape)) return {sphere->radius, {}};
  const BodyShape made = make_shape(body);
  if (std::holds_alternative<Compound>(body.shape)) return drawn(static_cast<btCompoundShape&>(*made.shape));
  return drawn(static_cast<btBoxShape&>(*made.shape), btTransform::getIdentity());
}

Scenario resolved(Scenario scenario) {
  resolve(scenario.body);
  for (Body& other : scenario.others) resolve(other);
  return scenario;
}

}  // namespace polhode::demos
