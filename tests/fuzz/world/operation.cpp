#include "fuzz/world/operation.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace polhode::fuzz {

namespace {

using Numbers = std::numeric_limits<btScalar>;

// Returns mostly ordinary numbers, and sometimes ones that make arithmetic fail.
btScalar read_scalar(Bytes& bytes, const Limits& limits) {
  const std::uint8_t kind = bytes.byte();
  if (kind < 224) return static_cast<btScalar>((kind < 100 ? 2 : 30) * bytes.unit());
  const btScalar largest = Numbers::max();
  const btScalar special[] = {0,
                              1,
                              -1,
                              -btScalar(0.0),
                              btScalar(1e-20),
                              Numbers::denorm_min(),
                              Numbers::epsilon(),
                              1000,
                              -1000,
                              btScalar(1e6),
                              btScalar(-1e15),
                              std::sqrt(largest),
                              largest,
                              -largest,
                              Numbers::infinity(),
                              -Numbers::infinity(),
                              Numbers::quiet_NaN()};
  const btScalar chosen = special[kind % (sizeof(special) / sizeof(special[0]))];
  const btScalar limit = btScalar(1e16);  // above this, products in the solver overflow
  return limits.non_finite || std::abs(chosen) < limit ? chosen : btScalar(0.5);
}

btVector3 read_vector(Bytes& bytes, const Limits& limits) {
  const std::uint8_t kind = bytes.byte();
  if (kind < 32) return {0, 0, 0};
  const btScalar x = read_scalar(bytes, limits);
  if (kind < 96) return {x, 0, 0};
  if (kind < 128) return {0, x, x};
  const btScalar y = read_scalar(bytes, limits);
  return {x, y, read_scalar(bytes, limits)};
}

// Half of all operations are steps and a sixteenth drive bodies. In worlds with multibodies, an eighth are
// for these.
Kind read_kind(Bytes& bytes, const Limits& limits) {
  constexpr std::uint8_t kFirstStep = 128;
  constexpr std::uint8_t kFirstOfMultibody = 96;
  constexpr std::uint8_t kFirstDrive = 80;
  constexpr std::uint8_t kKinds = static_cast<std::uint8_t>(Kind::step) + 1;
  constexpr std::uint8_t kKindsOfMultibody = static_cast<std::uint8_t>(Kind::drive) - kKinds;
  const std::uint8_t number = bytes.byte();
  if (number >= kFirstStep) return Kind::step;
  if (number >= kFirstOfMultibody && has_multibodies(limits.world_kind))
    return static_cast<Kind>(kKinds + number % kKindsOfMultibody);
  if (number >= kFirstDrive && number < kFirstOfMultibody) return Kind::drive;
  return static_cast<Kind>(number % kKinds);
}

bool is_allowed(const Operation& operation, const Limits& limits) {
  switch (operation.kind) {
    case Kind::detach:
    case Kind::attach:
      return limits.detaching;
    case Kind::continuous_collision:
      return limits.continuous_collision;
    case Kind::choose_scheme:
    case Kind::use_default_scheme:
    case Kind::default_scheme:
      return limits.managed;
    case Kind::within_step:
      return operation.place != Place::contact || limits.contact_callbacks;
    default:
      return true;
  }
}

}  // namespace

Operation read_operation(Bytes& bytes, const Limits& limits) {
  Operation operation;
  operation.kind = read_kind(bytes, limits);
  const std::uint8_t selection = bytes.byte();
  operation.variant = selection / 4U;
  operation.world = selection % 8 == 7 ? 1 : 0;
  if (operation.kind == Kind::step) {
    if (operation.variant >= 48) operation.x = read_scalar(bytes, limits);
    if (operation.variant >= 48) operation.y = read_scalar(bytes, limits);
    return operation;
  }
  operation.slot = bytes.below(kSlots);
  if (operation.kind == Kind::within_step) {
    operation.place = static_cast<Place>(operation.variant % static_cast<std::size_t>(Place::count));
  } else {
    operation.other = bytes.below(kSlots + 1);
    operation.a = read_vector(bytes, limits);
    operation.b = read_vector(bytes, limits);
    operation.x = read_scalar(bytes, limits);
    operation.y = read_scalar(bytes, limits);
  }
  if (!is_allowed(operation, limits)) operation.kind = Kind::velocity;
  return operation;
}

std::string text(const Operation& operation) {
  static const char* const names[] = {"velocity",
                                      "kick",
                                      "damping",
                                      "factors",
                                      "flags",
                                      "mass",
                                      "teleport",
                                      "activation",
                                      "choose_scheme",
                                      "release",
                                      "use_default_scheme",
                                      "add",
                                      "remove",
                                      "put_back",
                                      "erase",
                                      "gravity",
                                      "kinematic",
                                      "join",
                                      "unjoin",
                                      "motor",
                                      "default_scheme",
                                      "clear_default_scheme",
                                      "detach",
                                      "attach",
                                      "renew_second_world",
                                      "continuous_collision",
                                      "material",
                                      "settings",
                                      "within_step",
                                      "step",
                                      "add_multibody",
                                      "take_multibody",
                                      "erase_multibody",
                                      "move_multibody",
                                      "push_multibody",
                                      "set_multibody",
                                      "choose_for_multibody",
                                      "pin_multibody",
                                      "drive"};
  static_assert(sizeof(names) / sizeof(names[0]) == static_cast<std::size_t>(Kind::count));
  std::ostringstream out;
  out.precision(std::numeric_limits<btScalar>::max_digits10);
  const auto vector = [&out](const btVector3& v) {
    out << " (" << v.x() << ' ' << v.y() << ' ' << v.z() << ')';
  };
  out << names[static_cast<std::size_t>(operation.kind)] << " variant " << operation.variant << " world "
      << operation.world << " slot " << operation.slot << " other " << operation.other << " place "
      << static_cast<int>(operation.place);
  vector(operation.a);
  vector(operation.b);
  out << ' ' << operation.x << ' ' << operation.y;
  return out.str();
}

}  // namespace polhode::fuzz
