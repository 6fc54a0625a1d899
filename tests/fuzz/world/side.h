#pragma once

#include <btBulletDynamicsCommon.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/world/operation.h"
#include "polhode/bullet/rotation_control.h"
#include "polhode/bullet/rotation_plugin.h"

namespace polhode::fuzz {

enum class Way : std::uint8_t { rotation_world, plugin, plain };

/// Ends the fuzzer with a message.
[[noreturn]] void fail(const std::string& what);

/// Pose, velocities and inverse inertia in the world, for messages.
std::string numbers(const btRigidBody& body);

/// A body and what the application may expect of it.
class Slot {
 public:
  Slot() = default;
  ~Slot() { destroy(); }
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;

  /// Makes a body, always at the same address if `in_place`, so that a new body may be taken for an old one.
  void make(const btRigidBody::btRigidBodyConstructionInfo& info, bool in_place);
  void destroy();
  btRigidBody* body() const { return body_; }

  static constexpr int kLimbo = -1;
  int world = kLimbo;
  int flags = 0;                 ///< as the application left them
  bool left_non_finite = false;  ///< by an operation within the step, after the library was done
  std::unique_ptr<btMotionState> motion_state;

 private:
  alignas(16) std::array<unsigned char, sizeof(btRigidBody)> memory_{};
  std::unique_ptr<btRigidBody> heap_;
  btRigidBody* body_ = nullptr;
};

/// The worlds of one application, rotated in one of the ways. Every operation is done on each side alike.
class Side {
 public:
  Side(Way way, const Limits& limits);
  ~Side();
  Side(const Side&) = delete;
  Side& operator=(const Side&) = delete;

  /// Any operation but a step.
  void apply(const Operation& operation);
  /// The operations of `script` are done within the step.
  void step(const Operation& operation, const std::vector<Operation>& script);

  /// Checks what the library promises after a step of the world.
  void check(std::size_t world);

  const Slot& slot(std::size_t index) const { return slots_[index]; }
  /// Null for plain Bullet, or a world that does not exist.
  const RotationControl* rotation(std::size_t world) const;
  /// The slots of the bodies in each overlapping pair, in Bullet's order.
  std::vector<std::pair<int, int>> pairs(std::size_t world) const;
  /// Returns true if a number that is not finite has been seen in a body or by the library.
  bool has_seen_non_finite() const { return has_seen_non_finite_; }

  /// Called by Bullet and by the parts of a side.
  void in_step(Place place, btRigidBody* a = nullptr, btRigidBody* b = nullptr);

 private:
  struct World;
  enum class Choice : std::uint8_t { unset, released, scheme };
  struct Joint {
    std::unique_ptr<btTypedConstraint> constraint;
    std::size_t world = 0;
    const btRigidBody* a = nullptr;
    const btRigidBody* b = nullptr;
  };

  void make_world(std::size_t index);
  void renew_second_world(const Operation& operation);
  void apply_to_body(const Operation& operation, Slot& slot);
  void add(const Operation& operation, Slot& slot);
  void put(Slot& slot, std::size_t world);
  void remove(Slot& slot);
  void join(const Operation& operation);
  void unjoin(Joint& joint);
  void choose(const Operation& operation, std::size_t index);
  bool is_rotated(const World& world) const;
  bool is_expected_to_be_managed(std::size_t world, std::size_t slot) const;
  void forget_choices_of_absent(std::size_t world);
  void check_body(std::size_t world, std::size_t index);

  Way way_;
  Limits limits_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::array<Slot, kSlots> slots_;
  std::array<std::unique_ptr<World>, 2> worlds_;
  std::array<Joint, kJoints> joints_;
  std::array<std::array<Choice, kSlots>, 2> choices_{};
  std::array<bool, 2> has_default_{};
  std::unique_ptr<RotationPlugin> orphan_;  // a plugin whose world is gone
  std::vector<Operation> script_;
  std::size_t stepped_ = 0;
  bool is_in_step_ = false;
  bool has_taken_step_ = false;
  bool has_seen_non_finite_ = false;
};

}  // namespace polhode::fuzz
