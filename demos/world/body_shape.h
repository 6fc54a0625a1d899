#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <memory>
#include <vector>

#include "record/drawn_body.h"
#include "scenario/scenario.h"

namespace polhode::demos {

/// A Bullet shape with what it needs to stay alive.
struct BodyShape {
  std::vector<std::unique_ptr<btCollisionShape>> children;
  std::unique_ptr<btCollisionShape> shape;
  Vector3 inertia_B;  ///< of the body: the scenario's, or else what Bullet computes for the shape
};

/// @throws std::invalid_argument if the shape's inertia is out of kInertiaRange.
BodyShape make_shape(const Body& body);

/// The same shape to be drawn, in the body's axes.
DrawnBody drawn_body(const Body& body);

/// The scenario with the inertia of each body spelled out.
/// @throws std::invalid_argument if it cannot be run, by make_shape or start_motion.
Scenario resolved(Scenario scenario);

}  // namespace polhode::demos
