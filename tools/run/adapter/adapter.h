#pragma once

#include <cstdint>

/// What the interposer and an adapter library say to each other. It names no type of Bullet's, because the
/// interposer does not know Bullet's precision before the program steps its first world.
namespace polhode::run {

struct Counts {
  std::uint64_t rotated_worlds = 0;
  std::uint64_t worlds_left_to_bullet = 0;
  std::uint64_t steps = 0;              ///< of rotated worlds, substeps counted one by one
  std::uint64_t most_rigid_bodies = 0;  ///< rotated in one world at one time
  std::uint64_t most_multibodies = 0;   ///< likewise
  std::uint64_t diverged_bodies = 0;
  std::uint64_t non_finite_bodies = 0;
};

/// Prints one line for the user.
using Report = void (*)(const char* line);

/// An adapter library for one precision of Bullet. Nothing in it throws.
struct Adapter {
  /// Call it once, before the others. Returns false if there is no memory.
  bool (*start)(const char* scheme, Report report) noexcept;
  /// Takes a btDynamicsWorld that is about to step. Returns true if the library rotates its bodies.
  bool (*before_step)(void* world) noexcept;
  /// Takes the substeps that a rotated world has taken.
  void (*after_step)(std::uint64_t substeps) noexcept;
  Counts (*counts)() noexcept;
};

/// The one function that an adapter library exports.
using GetAdapter = const Adapter* (*)();
inline constexpr char kGetAdapter[] = "polhode_run_adapter";

}  // namespace polhode::run
