#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Returns the world as the class from which all whose bodies the library can rotate are derived.
/// @throws std::invalid_argument for any other world; the message says why, and which are valid.
btDiscreteDynamicsWorld& require_supported(btDynamicsWorld& world);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
