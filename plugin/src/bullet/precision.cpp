#include "polhode/bullet/precision.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <cstddef>
#include <cstdio>
#include <new>
#include <stdexcept>

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Returns the size of a serialized contact manifold in the loaded library, which differs between the
// precisions. The function called must be compiled into the library only: an inline function, virtual or not,
// would come from this program. The buffer is large enough for either precision, since the loaded constructor
// writes its own layout.
int serialized_size_in_loaded_bullet() {
  alignas(64) std::byte room[4 * sizeof(btPersistentManifold)];
  const auto* manifold = new (room) btPersistentManifold();
  const int size = manifold->calculateSerializeBufferSize();
  manifold->~btPersistentManifold();
  return size;
}

// Returns an error message, or null if the precisions match.
const char* mismatch() {
  static const bool matches =
      serialized_size_in_loaded_bullet() == static_cast<int>(sizeof(btPersistentManifoldData));
  if (matches) return nullptr;
#if POLHODE_BULLET_SCALAR_BITS == 64
  return "polhode::bullet_float64 is for double-precision Bullet, but the Bullet library loaded is "
         "single-precision: link polhode::bullet, or BulletDynamics-float64 and its companions";
#else
  return "polhode::bullet is for single-precision Bullet, but the Bullet library loaded is double-precision: "
         "link polhode::bullet_float64, or BulletDynamics and its companions without -float64";
#endif
}

// Also reports a mismatch when the program is loaded. The first Bullet object that the application creates
// may crash it before it calls this library: the loaded constructor writes past the end of the object.
[[maybe_unused]] const bool kReportedAtLoad = [] {
  if (const char* message = mismatch()) std::fprintf(stderr, "%s\n", message);
  return true;
}();

}  // namespace

void require_matching_bullet() {
  if (const char* message = mismatch()) throw std::runtime_error(message);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
