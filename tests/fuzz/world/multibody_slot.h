#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fuzz/world/operation.h"

namespace polhode::fuzz {

/// Formats pose and velocities of the base for messages.
std::string numbers(const btMultiBody& multibody);

/// Settings of the application, which a step must not change.
struct Switches {
  bool operator==(const Switches& other) const;

  bool gyroscopic_term = true;
  bool global_velocities = false;
  bool can_sleep = false;
  btScalar linear_damping = 0;
  btScalar angular_damping = 0;
  btScalar largest_velocity = 0;
};

/// A multibody and the state that the application expects. All multibodies of a slot get the same address:
/// the library documents that a new one then inherits the settings of the old one.
class MultibodySlot {
 public:
  MultibodySlot() = default;
  ~MultibodySlot() { destroy(); }
  MultibodySlot(const MultibodySlot&) = delete;
  MultibodySlot& operator=(const MultibodySlot&) = delete;

  void make(const Operation& operation, btCollisionShape& of_base, btCollisionShape& of_links);
  void destroy();
  btMultiBody* multibody() const { return multibody_; }

  void put(btMultiBodyDynamicsWorld& home);
  /// Removes the multibody and its pin.
  void take_out(btMultiBodyDynamicsWorld& home);
  /// Pins a point of the multibody to a point of the body, or of the world if `body` is null.
  void pin(btMultiBodyDynamicsWorld& home, const Operation& operation, btRigidBody* body);
  void unpin(btMultiBodyDynamicsWorld& home);
  /// Returns the body at the other end of the pin; null for the world or without a pin.
  const btRigidBody* pinned_to() const { return pinned_to_; }
  bool is_pinned() const { return pin_ != nullptr; }

  /// Returns true if it has a free base and no movable links.
  bool turns_as_one_body() const;
  Switches present_switches() const;

  static constexpr int kLimbo = -1;
  int world = kLimbo;
  Switches switches;  ///< as set by the application
  btVector3 force = btVector3(0, 0, 0);
  btVector3 torque = btVector3(0, 0, 0);
  bool left_non_finite = false;  ///< became non-finite within the step, after the library had finished
  bool is_finite_at_tick = false;

 private:
  void add_links(const Operation& operation);
  void add_collider(int link, btCollisionShape& shape, int user_index);

  alignas(16) std::array<unsigned char, sizeof(btMultiBody)> memory_{};
  btMultiBody* multibody_ = nullptr;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  std::unique_ptr<btMultiBodyPoint2Point> pin_;
  const btRigidBody* pinned_to_ = nullptr;
};

}  // namespace polhode::fuzz
