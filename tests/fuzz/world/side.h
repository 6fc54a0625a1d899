#pragma once

#include <btBulletDynamicsCommon.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/world/body_slot.h"
#include "fuzz/world/multibody_slot.h"
#include "fuzz/world/operation.h"
#include "fuzz/world/world.h"

namespace polhode::fuzz {

/// The worlds of one application, with one way of rotation. Every side performs the same operations.
class Side {
 public:
  Side(Way way, const Limits& limits);
  ~Side();
  Side(const Side&) = delete;
  Side& operator=(const Side&) = delete;

  /// Performs any operation except a step.
  void apply(const Operation& operation);
  /// Steps a world and performs the operations of `script` within the step.
  void step(const Operation& operation, const std::vector<Operation>& script);

  /// Checks the library's guarantees after a step of the world (side_checks.cpp).
  void check(std::size_t world);

  const BodySlot& slot(std::size_t index) const { return slots_[index]; }
  const MultibodySlot& multibody(std::size_t index) const { return multibodies_[index]; }
  /// Returns null for plain Bullet and for a world that does not exist.
  const RotationControl* rotation(std::size_t world) const;
  /// Returns the slots of the bodies in each overlapping pair, in Bullet's order.
  std::vector<std::pair<int, int>> pairs(std::size_t world) const;
  /// Returns true if a body or the library has seen a non-finite number, or Bullet has switched off a body.
  bool has_left_contract() const { return has_left_contract_; }

  /// Called by Bullet's callbacks, and by the other parts of a side.
  void in_step(Place place, btRigidBody* a = nullptr, btRigidBody* b = nullptr);

 private:
  enum class Choice : std::uint8_t { unset, released, scheme };
  struct Joint {
    std::unique_ptr<btTypedConstraint> constraint;
    std::size_t world = 0;
    const btRigidBody* a = nullptr;
    const btRigidBody* b = nullptr;
  };

  void make_world(std::size_t index);
  void renew_second_world(const Operation& operation);
  void add(const Operation& operation, BodySlot& slot);
  void put(BodySlot& slot, std::size_t world);
  void remove(BodySlot& slot);
  void join(const Operation& operation);
  void unjoin(Joint& joint);
  void choose(const Operation& operation, std::size_t index);
  void choose_default_scheme(const Operation& operation, std::size_t index);
  void drive(const Operation& operation);
  bool is_expected_to_be_managed(std::size_t world, std::size_t slot) const;
  void forget_choices_of_absent(std::size_t world);
  void check_body(std::size_t world, std::size_t index);
  void check_rotation(const BodyRotation& rotation, const std::string& name) const;
  void check_motion_state(const World& world, std::size_t index);

  // Defined in side_multibodies.cpp:
  btMultiBodyDynamicsWorld& multibody_world(std::size_t index) const;
  void apply_to_multibody(const Operation& operation);
  void put(MultibodySlot& slot, std::size_t world);
  void remove(MultibodySlot& slot);
  void pin(const Operation& operation, MultibodySlot& slot);
  void unpin_from(const btRigidBody& body);
  void leave_second_world(MultibodySlot& slot, bool with_bodies);
  void choose_for_multibody(const Operation& operation, std::size_t index);
  void forget_choices_of_absent_multibodies(std::size_t world);
  void begin_step_of_multibodies();
  void check_left_as_they_were(bool with_forces);
  bool is_multibody_expected_to_be_managed(std::size_t world, std::size_t index) const;
  /// Returns the number of managed multibodies.
  std::size_t check_multibodies(std::size_t world);
  void check_multibody(const RotationControl& rotation, std::size_t index);

  Way way_;
  Limits limits_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::array<BodySlot, kSlots> slots_;
  std::array<MultibodySlot, kMultibodies> multibodies_;
  std::array<std::unique_ptr<World>, 2> worlds_;
  std::array<Joint, kJoints> joints_;
  std::array<std::array<Choice, kSlots>, 2> choices_{};
  std::array<std::array<Choice, kMultibodies>, 2> multibody_choices_{};
  std::array<bool, 2> has_default_{};
  bool may_have_rotors_ = false;            ///< some body; it may be refused schemes without rotors
  std::unique_ptr<RotationPlugin> orphan_;  // a plugin whose world has been deleted
  std::vector<Operation> script_;
  std::size_t stepped_ = 0;
  bool is_in_step_ = false;
  bool has_taken_step_ = false;
  bool has_acted_in_motion_state_ = false;
  bool has_left_contract_ = false;
};

}  // namespace polhode::fuzz
