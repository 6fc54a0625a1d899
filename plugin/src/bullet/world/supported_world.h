#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Returns the world as a btDiscreteDynamicsWorld, the base of all supported worlds.
/// @throws std::invalid_argument for an unsupported world; the message says why, and which are valid.
btDiscreteDynamicsWorld& require_supported(btDynamicsWorld& world);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
