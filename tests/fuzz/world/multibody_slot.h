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

/// Pose and velocities of the base, for messages.
std::string numbers(const btMultiBody& multibody);

/// What an application sets once, and finds as it was after each step.
struct Switches {
  bool operator==(const Switches& other) const;

  bool gyroscopic_term = true;
  bool global_velocities = false;
  bool can_sleep = false;
  btScalar linear_damping = 0;
  btScalar angular_damping = 0;
  btScalar largest_velocity = 0;
};

/// A multibody and what the application may expect of it. All that a slot ever has are at one address: a
/// new one may be taken for an old one, and the library says that it then has its choice.
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
  /// With its pin.
  void take_out(btMultiBodyDynamicsWorld& home);
  /// Holds a point of it at a point of the body, or of the world if that is null.
  void pin(btMultiBodyDynamicsWorld& home, const Operation& operation, btRigidBody* body);
  void unpin(btMultiBodyDynamicsWorld& home);
  /// The body that it is pinned to; null also for the world.
  const btRigidBody* pinned_to() const { return pinned_to_; }
  bool is_pinned() const { return pin_ != nullptr; }

  /// Returns true if it is free and has no links but fixed ones.
  bool turns_as_one_body() const;
  Switches present_switches() const;

  static constexpr int kLimbo = -1;
  int world = kLimbo;
  Switches switches;  ///< as the application left them
  btVector3 force = btVector3(0, 0, 0);
  btVector3 torque = btVector3(0, 0, 0);
  bool left_non_finite = false;  ///< within the step, after the library was done
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
