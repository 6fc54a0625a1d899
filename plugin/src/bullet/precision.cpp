#include "polhode/bullet/precision.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <cstddef>
#include <cstdio>
#include <new>
#include <stdexcept>

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// How large the loaded library says its own serialised contact manifold is: the two precisions differ. It
// must be a function that is compiled into the library alone: an inline one, virtual or not, is taken from
// this program. The object is made in room enough for either, since the loaded constructor writes its own
// layout.
int serialised_size_in_loaded_bullet() {
  alignas(64) std::byte room[4 * sizeof(btPersistentManifold)];
  const auto* manifold = new (room) btPersistentManifold();
  const int size = manifold->calculateSerializeBufferSize();
  manifold->~btPersistentManifold();
  return size;
}

// Returns what is wrong, or a null pointer.
const char* mismatch() {
  static const bool matches =
      serialised_size_in_loaded_bullet() == static_cast<int>(sizeof(btPersistentManifoldData));
  if (matches) return nullptr;
#if POLHODE_BULLET_SCALAR_BITS == 64
  return "polhode::bullet_float64 is for double-precision Bullet, but the Bullet library loaded is "
         "single-precision: link polhode::bullet, or BulletDynamics-float64 and its companions";
#else
  return "polhode::bullet is for single-precision Bullet, but the Bullet library loaded is double-precision: "
         "link polhode::bullet_float64, or BulletDynamics and its companions without -float64";
#endif
}

// Said when the program is loaded too: the first object of Bullet's that the application makes, long before
// it reaches this library, may end it, since the loaded constructor writes past the object's end.
[[maybe_unused]] const bool kToldAtLoad = [] {
  if (const char* message = mismatch()) std::fprintf(stderr, "%s\n", message);
  return true;
}();

}  // namespace

void require_matching_bullet() {
  if (const char* message = mismatch()) throw std::runtime_error(message);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
