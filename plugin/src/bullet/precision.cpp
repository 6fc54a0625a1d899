#include "polhode/bullet/precision.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <cstddef>
#include <new>
#include <stdexcept>

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// How large the loaded library's own btCollisionObject says its serialised form is: the two precisions
// differ. The object is made in room enough for either, since the loaded constructor writes its own layout.
int serialised_size_in_loaded_bullet() {
  alignas(64) std::byte room[4 * sizeof(btCollisionObject)];
  auto* object = new (room) btCollisionObject();
  // Through a volatile pointer: the call must go through the loaded library's virtual table.
  btCollisionObject* volatile loaded = object;
  const int size = loaded->calculateSerializeBufferSize();
  loaded->~btCollisionObject();
  return size;
}

}  // namespace

void require_matching_bullet() {
  static const bool matches =
      serialised_size_in_loaded_bullet() == static_cast<int>(sizeof(btCollisionObjectData));
  if (matches) return;
#if POLHODE_BULLET_SCALAR_BITS == 64
  throw std::runtime_error(
      "polhode::bullet_float64 is for double-precision Bullet, but the Bullet library loaded is "
      "single-precision: "
      "link polhode::bullet, or BulletDynamics-float64 and its companions");
#else
  throw std::runtime_error(
      "polhode::bullet is for single-precision Bullet, but the Bullet library loaded is double-precision: "
      "link polhode::bullet_float64, or BulletDynamics and its companions without -float64");
#endif
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
