#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <memory>
#include <vector>

#include "record/drawn_body.h"
#include "scenario/scenario.h"

namespace polhode::demos {

/// A Bullet shape together with the objects that it refers to.
struct BodyShape {
  std::vector<std::unique_ptr<btCollisionShape>> children;
  std::unique_ptr<btCollisionShape> shape;
  Vector3 inertia_B;  ///< of the body: the scenario's, or those that Bullet computes for the shape
};

/// @throws std::invalid_argument if the shape's inertia is out of kInertiaRange
BodyShape make_shape(const Body& body);

/// Returns the same shape for drawing, in body axes.
DrawnBody drawn_body(const Body& body);

/// Returns the scenario with the inertia of each body filled in.
/// @throws std::invalid_argument if it cannot be run, as make_shape and start_motion
Scenario resolved(Scenario scenario);

}  // namespace polhode::demos
