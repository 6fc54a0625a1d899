#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>

#include "fuzz/world/operation.h"

namespace polhode::fuzz {

/// Creates a joint between two bodies, or a body and the world, of the kind and at the pivots that the
/// operation specifies. Returns null if Bullet has no such joint.
std::unique_ptr<btTypedConstraint> make_joint(const Operation& operation, btRigidBody& a,
                                              btRigidBody* b_or_world);

}  // namespace polhode::fuzz
