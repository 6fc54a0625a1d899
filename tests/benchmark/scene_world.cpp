#include "benchmark/scene_world.h"

#include "polhode/bullet/rotation_world.h"

namespace polhode::benchmarks {

namespace {

// Sizes the pools for the whole pile; otherwise the worlds would allocate at times when contacts appear.
btDefaultCollisionConstructionInfo pools_for(std::size_t boxes) {
  btDefaultCollisionConstructionInfo info;
  const int contacts_at_most = 16 * static_cast<int>(boxes);
  info.m_defaultMaxPersistentManifoldPoolSize = contacts_at_most;
  info.m_defaultMaxCollisionAlgorithmPoolSize = contacts_at_most;
  return info;
}

btDefaultCollisionConstructionInfo pools_for(const SceneStart& start) {
  return start.floor ? pools_for(start.boxes.size()) : btDefaultCollisionConstructionInfo();
}

}  // namespace

SceneWorld::SceneWorld(const SceneStart& start, RotatedBy rotated_by, const SchemePointer& scheme)
    : configuration_(pools_for(start)) {
  make_world(rotated_by, scheme);
  world_->setGravity(start.gravity);
  for (const btVector3& half_extents : start.half_extents) {
    shapes_.push_back(std::make_unique<btBoxShape>(half_extents));
  }
  if (start.floor) add_floor();
  motion_states_.reserve(start.boxes.size());
  bodies_.reserve(start.boxes.size());
  for (const BoxStart& box : start.boxes) add_box(box);
  if (rotated_by == RotatedBy::rotation_plugin) {
    plugin_ = std::make_unique<RotationPlugin>(*world_);
    rotation_ = &plugin_->rotation();
    rotation_->set_default_scheme(scheme);
  }
}

SceneWorld::~SceneWorld() {
  // Destroy the world before its bodies. Removing 100,000 bodies one by one would search the list each time.
  plugin_.reset();
  world_.reset();
}

void SceneWorld::kick() {
  kick_sign_ = -kick_sign_;
  const btVector3 impulse_W = btVector3(1, 2, 3) * (kick_sign_ * btScalar(1e-3));
  for (const auto& body : bodies_) body->applyTorqueImpulse(impulse_W);
}

void SceneWorld::make_world(RotatedBy rotated_by, const SchemePointer& scheme) {
  if (rotated_by != RotatedBy::rotation_world) {
    world_ = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_);
    return;
  }
  auto world = std::make_unique<RotationWorld<btDiscreteDynamicsWorld>>(&dispatcher_, &broadphase_, &solver_,
                                                                        &configuration_);
  rotation_ = &world->rotation();
  rotation_->set_default_scheme(scheme);
  world_ = std::move(world);
}

void SceneWorld::add_floor() {
  floor_shape_ = std::make_unique<btBoxShape>(btVector3(500, 500, 1));
  btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, floor_shape_.get());
  info.m_startWorldTransform.setOrigin(btVector3(0, 0, -1));
  floor_ = std::make_unique<btRigidBody>(info);
  world_->addRigidBody(floor_.get());
}

void SceneWorld::add_box(const BoxStart& start) {
  btBoxShape& shape = *shapes_[start.shape];
  btVector3 inertia_B;
  shape.calculateLocalInertia(start.mass_kg, inertia_B);
  motion_states_.push_back(std::make_unique<btDefaultMotionState>(start.pose));
  bodies_.push_back(
      std::make_unique<btRigidBody>(start.mass_kg, motion_states_.back().get(), &shape, inertia_B));
  btRigidBody& body = *bodies_.back();
  body.setLinearVelocity(start.velocity_W);
  body.setAngularVelocity(start.omega_W);
  body.setActivationState(DISABLE_DEACTIVATION);
  world_->addRigidBody(&body);
}

}  // namespace polhode::benchmarks
