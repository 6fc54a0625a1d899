#pragma once

#include <cstdint>

/// The interface between the interposer and an adapter library. It uses no Bullet types, because the
/// interposer does not know Bullet's precision before the program steps its first world.
namespace polhode::run {

struct Counts {
  std::uint64_t rotated_worlds = 0;
  std::uint64_t worlds_left_to_bullet = 0;
  std::uint64_t steps = 0;              ///< steps of rotated worlds, counting each substep
  std::uint64_t most_rigid_bodies = 0;  ///< rotated in one world at one time
  std::uint64_t most_multibodies = 0;   ///< rotated in one world at one time
  std::uint64_t diverged_bodies = 0;
  std::uint64_t non_finite_bodies = 0;
};

/// Prints one line for the user.
using Report = void (*)(const char* line);

/// An adapter library for one precision of Bullet. Its functions do not throw.
struct Adapter {
  /// Call once, before the other functions. Returns false if memory runs out.
  bool (*start)(const char* scheme, Report report) noexcept;
  /// `world` is a btDynamicsWorld that is about to step. Returns true if the library rotates its bodies.
  bool (*before_step)(void* world) noexcept;
  /// Adds the number of substeps that a rotated world has taken.
  void (*after_step)(std::uint64_t substeps) noexcept;
  Counts (*counts)() noexcept;
};

/// The one function that an adapter library exports.
using GetAdapter = const Adapter* (*)();
inline constexpr char kGetAdapter[] = "polhode_run_adapter";

}  // namespace polhode::run
