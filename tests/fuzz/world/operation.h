#pragma once

#include <LinearMath/btVector3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/bytes.h"

namespace polhode::fuzz {

constexpr std::size_t kSlots = 12;  ///< bodies that a world may have
constexpr std::size_t kJoints = 6;
constexpr std::size_t kMultibodies = 4;  ///< many that touch cost Bullet's solver about their number^4

/// One thing that an application does to a world, its bodies or the library.
enum class Kind : std::uint8_t {
  // Within a step as well as between two steps, and to a body that is in contact:
  velocity,
  kick,
  damping,
  factors,
  flags,
  mass,
  // In tick callbacks, in actions and between steps:
  teleport,
  activation,
  choose_scheme,
  release,
  use_default_scheme,
  add,
  remove,
  put_back,
  erase,
  // Between two steps alone:
  gravity,
  kinematic,
  join,
  unjoin,
  motor,
  default_scheme,
  clear_default_scheme,
  detach,
  attach,
  renew_second_world,
  continuous_collision,
  material,
  settings,
  within_step,  ///< the next operation is done within the next step
  step,
  // In tick callbacks, in actions and between steps, in worlds with multibodies:
  add_multibody,
  take_multibody,  ///< out of its world, or back into one
  erase_multibody,
  move_multibody,
  push_multibody,
  set_multibody,
  choose_for_multibody,
  pin_multibody,
  // In tick callbacks, in actions and between steps:
  drive,  ///< a torque law, rotors, motors
  count
};

/// Where in a step an operation is done.
enum class Place : std::uint8_t { before, contact, action, after, motion_state, count };

/// An operation with all its numbers, so that it can be done alike on several worlds.
struct Operation {
  Kind kind = Kind::step;
  std::size_t variant = 0;
  std::size_t world = 0;
  std::size_t slot = 0;
  std::size_t other = 0;
  btVector3 a = btVector3(0, 0, 0);
  btVector3 b = btVector3(0, 0, 0);
  btScalar x = 0;
  btScalar y = 0;
  Place place = Place::before;  ///< of within_step
};

/// The class of Bullet's worlds, or a discrete world with an MLCP solver.
enum class WorldKind : std::uint8_t { discrete, soft_rigid, multi_body, mlcp, soft_multi_body };

constexpr bool has_multibodies(WorldKind kind) {
  return kind == WorldKind::multi_body || kind == WorldKind::soft_multi_body;
}
constexpr bool has_soft_bodies(WorldKind kind) {
  return kind == WorldKind::soft_rigid || kind == WorldKind::soft_multi_body;
}
constexpr bool is_of_multibody(Kind kind) {
  return kind > Kind::step && kind < Kind::drive;
}

/// What the operations of an input may do. The fewer, the more can be checked.
struct Limits {
  bool non_finite = false;
  bool detaching = false;
  bool continuous_collision = false;
  bool contact_callbacks = false;
  bool managed = true;  ///< else every body is Bullet's
  WorldKind world_kind = WorldKind::discrete;
};

Operation read_operation(Bytes& bytes, const Limits& limits);
std::string text(const Operation& operation);

}  // namespace polhode::fuzz
