#pragma once

/// The one of Bullet's two precisions that this code is compiled for. Bullet's libraries export the same
/// symbols in both, so that a mix links and then crashes. Everything here therefore lives in a namespace
/// named after the precision. A mix is refused when compiled (below) or linked (the namespace); a mix that
/// passes both is named on stderr when the program is loaded, and refused when a world is taken on
/// (require_matching_bullet).

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

/// @throws std::runtime_error that names both precisions, if the Bullet library loaded into this process was
/// built in another one than this code.
void require_matching_bullet();

}  // namespace POLHODE_PRECISION
}  // namespace polhode
