#pragma once

#include <vector>

class btRigidBody;

/// Returns the rigid bodies that were added to Bullet worlds in this process, in order.
///
/// The Bullet plugin of ignition-physics 5 lacks the feature that sets the velocity of a free body
/// (SetFreeGroupWorldVelocity) and hides its world. The program therefore replaces Bullet's virtual function
/// btDiscreteDynamicsWorld::addRigidBody with one that stores the body and calls Bullet's. Nothing else in
/// Bullet is changed.
const std::vector<btRigidBody*>& added_bullet_bodies();
