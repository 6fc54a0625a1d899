#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>

#include "fuzz/world/operation.h"

namespace polhode::fuzz {

/// Returns a joint of two bodies, or of one and the world, of the kind and at the places that the operation
/// says; null where Bullet has none for these.
std::unique_ptr<btTypedConstraint> make_joint(const Operation& operation, btRigidBody& a,
                                              btRigidBody* b_or_world);

}  // namespace polhode::fuzz
