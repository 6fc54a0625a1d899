#include "fuzz/world/joints.h"

#include "fuzz/world/usable_numbers.h"

namespace polhode::fuzz {

std::unique_ptr<btTypedConstraint> make_joint(const Operation& operation, btRigidBody& a,
                                              btRigidBody* b_or_world) {
  const bool to_world = b_or_world == nullptr;
  btRigidBody& b = to_world ? a : *b_or_world;
  // Bullet divides by zero in joints between two bodies without mass.
  if (a.getInvMass() == 0 && b.getInvMass() == 0) return nullptr;
  const btTransform frame_a(btQuaternion(btVector3(1, 1, 0).normalized(), operation.x), operation.a);
  const btTransform frame_b(btQuaternion::getIdentity(), operation.b);
  if (!is_finite(frame_a.getBasis())) return nullptr;
  const btVector3 axis = frame_a.getBasis().getColumn(2);
  switch (operation.variant % 4) {
    case 0:
      if (to_world) return std::make_unique<btHingeConstraint>(a, operation.a, axis);
      return std::make_unique<btHingeConstraint>(a, b, operation.a, operation.b, axis, axis);
    case 1:
      if (to_world) return std::make_unique<btPoint2PointConstraint>(a, operation.a);
      return std::make_unique<btPoint2PointConstraint>(a, b, operation.a, operation.b);
    case 2:
      if (to_world) return nullptr;
      return std::make_unique<btFixedConstraint>(a, b, frame_a, frame_b);
    default:
      if (to_world) return std::make_unique<btGeneric6DofSpring2Constraint>(a, frame_a);
      return std::make_unique<btGeneric6DofSpring2Constraint>(a, b, frame_a, frame_b);
  }
}

}  // namespace polhode::fuzz
