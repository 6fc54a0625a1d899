#pragma once

#include <vector>

class btRigidBody;

/// The rigid bodies that were added to a world of Bullet's in this process, in that order.
///
/// The Bullet plugin of ignition-physics 5 has no feature that sets the velocity of a free body
/// (SetFreeGroupWorldVelocity), and keeps its world to itself. The program therefore stands in for Bullet's virtual
/// btDiscreteDynamicsWorld::addRigidBody, notes the body and calls Bullet's. Nothing else of Bullet's is touched.
const std::vector<btRigidBody*>& added_bullet_bodies();
