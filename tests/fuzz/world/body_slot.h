#pragma once

#include <btBulletDynamicsCommon.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace polhode::fuzz {

/// Formats a vector for messages.
std::string text(const btVector3& v);

/// Formats pose, velocities and inverse world inertia for messages.
std::string numbers(const btRigidBody& body);

/// Stores the last pose that Bullet set.
class ShownPose final : public btMotionState {
 public:
  ShownPose(const btTransform& start, std::function<void()> on_show)
      : pose(start), on_show_(std::move(on_show)) {}
  void getWorldTransform(btTransform& start) const override { start = pose; }
  void setWorldTransform(const btTransform& shown) override {
    pose = shown;
    is_shown = true;
    on_show_();
  }

  btTransform pose;
  bool is_shown = false;

 private:
  std::function<void()> on_show_;
};

/// A body and the state that the application expects.
class BodySlot {
 public:
  BodySlot() = default;
  ~BodySlot() { destroy(); }
  BodySlot(const BodySlot&) = delete;
  BodySlot& operator=(const BodySlot&) = delete;

  /// Creates a body. With `in_place` it always gets the same address, so that it could be confused with the
  /// old one.
  void make(const btRigidBody::btRigidBodyConstructionInfo& info, bool in_place);
  void destroy();
  btRigidBody* body() const { return body_; }

  static constexpr int kLimbo = -1;
  int world = kLimbo;
  int flags = 0;                 ///< as set by the application
  bool left_non_finite = false;  ///< became non-finite within the step, after the library had finished
  bool is_finite_at_tick = false;
  std::unique_ptr<ShownPose> motion_state;

 private:
  alignas(16) std::array<unsigned char, sizeof(btRigidBody)> memory_{};
  std::unique_ptr<btRigidBody> heap_;
  btRigidBody* body_ = nullptr;
};

}  // namespace polhode::fuzz
