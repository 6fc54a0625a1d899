#pragma once

/// Selects the Bullet precision that this code is compiled for. Single- and double-precision Bullet export
/// the same symbols, so mixing them links and then crashes. All declarations therefore live in a namespace
/// named after the precision. A mismatch is an error when compiling (below) or linking (the namespace). A
/// mismatch that passes both prints a message to stderr when the program is loaded, and throws when a world
/// is attached (require_matching_bullet).

#include <LinearMath/btScalar.h>

#if !defined(POLHODE_BULLET_SCALAR_BITS)
#error \
    "polhode: link the target polhode::bullet (single-precision Bullet) or polhode::bullet_float64 (double)"
#elif POLHODE_BULLET_SCALAR_BITS == 64 && !defined(BT_USE_DOUBLE_PRECISION)
#error \
    "polhode::bullet_float64 is for double-precision Bullet, but BT_USE_DOUBLE_PRECISION is not defined: \
link polhode::bullet, or a double-precision Bullet"
#elif POLHODE_BULLET_SCALAR_BITS == 32 && defined(BT_USE_DOUBLE_PRECISION)
#error \
    "polhode::bullet is for single-precision Bullet, but BT_USE_DOUBLE_PRECISION is defined: \
link polhode::bullet_float64"
#endif

#if POLHODE_BULLET_SCALAR_BITS == 64
#define POLHODE_PRECISION bullet_float64
#else
#define POLHODE_PRECISION bullet_float32
#endif

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Checks that the loaded Bullet library has the precision that this code was compiled for.
/// @throws std::runtime_error that names both precisions if they differ.
void require_matching_bullet();

}  // namespace POLHODE_PRECISION
}  // namespace polhode
