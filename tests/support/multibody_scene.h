#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/scene.h"

namespace polhode::testing {

/// A part fixed to a multibody's base: its centre of mass and axes in the base's frame.
struct FixedPart {
  btScalar mass;
  btVector3 inertia;
  btTransform pose_B;
};

/// A multibody without links and damping, with a base collider, as in most applications.
struct MultibodyInScene {
  MultibodyInScene(btScalar mass, const btVector3& inertia_B, const btTransform& pose,
                   const std::vector<FixedPart>& parts)
      : multibody(static_cast<int>(parts.size()), mass, inertia_B, /*fixedBase=*/false, /*canSleep=*/false) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const btQuaternion q_part_B = parts[i].pose_B.getRotation().inverse();
      multibody.setupFixed(static_cast<int>(i), parts[i].mass, parts[i].inertia, -1, q_part_B,
                           parts[i].pose_B.getOrigin(), btVector3(0, 0, 0));
    }
    multibody.finalizeMultiDof();
    multibody.setLinearDamping(0);
    multibody.setAngularDamping(0);
    multibody.setBaseWorldTransform(pose);
  }

  void set_shape(btCollisionShape& shape) {
    collider = std::make_unique<btMultiBodyLinkCollider>(&multibody, -1);
    collider->setCollisionShape(&shape);
    collider->setWorldTransform(multibody.getBaseWorldTransform());
    multibody.setBaseCollider(collider.get());
  }

  btMultiBody multibody;
  std::unique_ptr<btMultiBodyLinkCollider> collider;
};

/// A scene of multibodies and rigid bodies, initially without gravity.
template <class World = btMultiBodyDynamicsWorld>
class MultibodyScene : public Scene<World> {
 public:
  ~MultibodyScene() {
    for (const auto& joint : joints_) this->world().removeMultiBodyConstraint(joint.get());
    for (const auto& added : multibodies_) take_out(*added);
  }

  btMultiBody& add_multibody(btScalar mass, const btVector3& inertia_B, const btTransform& pose,
                             btCollisionShape& shape) {
    MultibodyInScene& added = make(mass, inertia_B, pose);
    added.set_shape(shape);
    // Without an explicit group Bullet would filter the collider as a static object.
    this->world().addCollisionObject(added.collider.get(), btBroadphaseProxy::DefaultFilter,
                                     btBroadphaseProxy::AllFilter);
    this->world().addMultiBody(&added.multibody);
    return added.multibody;
  }

  /// Adds a multibody of 1 kg without a collider that spins at omega_W in empty space.
  btMultiBody& add_free_multibody(const btVector3& inertia_B, const btVector3& omega_W,
                                  const btQuaternion& q_WB = btQuaternion::getIdentity(),
                                  const std::vector<FixedPart>& parts = {}) {
    const btVector3 origin(0, 0, btScalar(100) + btScalar(10) * static_cast<btScalar>(multibodies_.size()));
    btMultiBody& multibody = make(1, inertia_B, btTransform(q_WB, origin), parts).multibody;
    multibody.setBaseOmega(omega_W);
    this->world().addMultiBody(&multibody);
    return multibody;
  }

  /// Adds a box with the inertia of its shape.
  btMultiBody& add_multibody_box(const btVector3& half_extents, btScalar mass, const btTransform& pose) {
    btCollisionShape& shape = this->box(half_extents);
    btVector3 inertia_B;
    shape.calculateLocalInertia(mass, inertia_B);
    return add_multibody(mass, inertia_B, pose, shape);
  }

  template <class Joint, class... Arguments>
  Joint& join_multibody(Arguments&&... arguments) {
    auto joint = std::make_unique<Joint>(std::forward<Arguments>(arguments)...);
    Joint& added = *joint;
    joints_.push_back(std::move(joint));
    this->world().addMultiBodyConstraint(&added);
    return added;
  }

  /// Pins a point of the base to its present place in the world.
  void pin(btMultiBody& multibody, const btVector3& point_B) {
    const btVector3 point_W = multibody.getBaseWorldTransform() * point_B;
    auto& joint = join_multibody<btMultiBodyPoint2Point>(&multibody, -1, static_cast<btRigidBody*>(nullptr),
                                                         point_B, point_W);
    joint.setMaxAppliedImpulse(btScalar(1e9));
  }

  /// Removes the multibody from the world and deletes it.
  void remove_multibody(btMultiBody& multibody) {
    for (auto it = multibodies_.begin(); it != multibodies_.end(); ++it) {
      if (&(*it)->multibody != &multibody) continue;
      take_out(**it);
      multibodies_.erase(it);
      return;
    }
  }

 private:
  MultibodyInScene& make(btScalar mass, const btVector3& inertia_B, const btTransform& pose,
                         const std::vector<FixedPart>& parts = {}) {
    multibodies_.push_back(std::make_unique<MultibodyInScene>(mass, inertia_B, pose, parts));
    return *multibodies_.back();
  }
  void take_out(MultibodyInScene& added) {
    this->world().removeMultiBody(&added.multibody);
    if (added.collider != nullptr) this->world().removeCollisionObject(added.collider.get());
  }

  std::vector<std::unique_ptr<MultibodyInScene>> multibodies_;
  std::vector<std::unique_ptr<btMultiBodyConstraint>> joints_;
};

/// @name The two ways to use the library
/// @{
class MultibodiesInRotationWorld : public MultibodyScene<RotationWorld<btMultiBodyDynamicsWorld>> {
 public:
  static constexpr const char* kName = "InRotationWorld";
  RotationControl& rotation() { return world().rotation(); }
};

class MultibodiesUnderRotationPlugin : public MultibodyScene<> {
 public:
  static constexpr const char* kName = "UnderRotationPlugin";
  RotationControl& rotation() { return plugin_.rotation(); }
  RotationPlugin& plugin() { return plugin_; }

 private:
  RotationPlugin plugin_{world()};
};

using BothWaysOfMultibodies = ::testing::Types<MultibodiesInRotationWorld, MultibodiesUnderRotationPlugin>;
/// @}

/// Returns the rotational kinetic energy from the multibody's velocity, J.
inline double shown_rotational_energy(const btMultiBody& multibody) {
  const btVector3 omega_B = quatRotate(multibody.getWorldToBaseRot(), multibody.getBaseOmega());
  double twice = 0;
  for (int i = 0; i < 3; ++i) {
    const double rate = static_cast<double>(omega_B[i]);
    twice += static_cast<double>(multibody.getBaseInertia()[i]) * rate * rate;
  }
  return 0.5 * twice;
}

}  // namespace polhode::testing
