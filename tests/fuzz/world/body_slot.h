#pragma once

#include <btBulletDynamicsCommon.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace polhode::fuzz {

/// For messages.
std::string text(const btVector3& v);

/// Pose, velocities and inverse inertia in the world, for messages.
std::string numbers(const btRigidBody& body);

/// Keeps the pose that it was shown last.
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

/// A body and what the application may expect of it.
class BodySlot {
 public:
  BodySlot() = default;
  ~BodySlot() { destroy(); }
  BodySlot(const BodySlot&) = delete;
  BodySlot& operator=(const BodySlot&) = delete;

  /// Makes a body, always at the same address if `in_place`, so that a new body may be taken for an old one.
  void make(const btRigidBody::btRigidBodyConstructionInfo& info, bool in_place);
  void destroy();
  btRigidBody* body() const { return body_; }

  static constexpr int kLimbo = -1;
  int world = kLimbo;
  int flags = 0;                 ///< as the application left them
  bool left_non_finite = false;  ///< within the step, after the library was done
  bool is_finite_at_tick = false;
  std::unique_ptr<ShownPose> motion_state;

 private:
  alignas(16) std::array<unsigned char, sizeof(btRigidBody)> memory_{};
  std::unique_ptr<btRigidBody> heap_;
  btRigidBody* body_ = nullptr;
};

}  // namespace polhode::fuzz
