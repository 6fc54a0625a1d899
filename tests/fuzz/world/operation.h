#pragma once

#include <LinearMath/btVector3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/bytes.h"

namespace polhode::fuzz {

constexpr std::size_t kSlots = 12;  ///< bodies per world, at most
constexpr std::size_t kJoints = 6;
constexpr std::size_t kMultibodies = 4;  ///< Bullet's solver takes O(n^4) for n in contact

/// An action of the application on a world, its bodies or the library.
enum class Kind : std::uint8_t {
  // Allowed between steps and anywhere within a step, even on a body in contact:
  velocity,
  kick,
  damping,
  factors,
  flags,
  mass,
  // Allowed in tick callbacks, in actions and between steps:
  teleport,
  activation,
  choose_scheme,
  release,
  use_default_scheme,
  add,
  remove,
  put_back,
  erase,
  // Allowed only between steps:
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
  within_step,  ///< perform the next operation within the next step
  step,
  // Allowed in tick callbacks, in actions and between steps, in worlds with multibodies:
  add_multibody,
  take_multibody,  ///< remove from the world, or add again
  erase_multibody,
  move_multibody,
  push_multibody,
  set_multibody,
  choose_for_multibody,
  pin_multibody,
  // Allowed in tick callbacks, in actions and between steps:
  drive,  ///< set a torque law, rotors or motors
  count
};

/// Where within a step an operation is performed.
enum class Place : std::uint8_t { before, contact, action, after, motion_state, count };

/// An operation with all its numbers, so that it can be repeated on several worlds.
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
  Place place = Place::before;  ///< for within_step
};

/// The class of the Bullet world; mlcp is a discrete world with an MLCP solver.
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

/// The operations that an input may use. Fewer operations allow stricter checks.
struct Limits {
  bool non_finite = false;
  bool detaching = false;
  bool continuous_collision = false;
  bool contact_callbacks = false;
  bool managed = true;  ///< false: Bullet rotates every body
  WorldKind world_kind = WorldKind::discrete;
};

Operation read_operation(Bytes& bytes, const Limits& limits);
std::string text(const Operation& operation);

}  // namespace polhode::fuzz
