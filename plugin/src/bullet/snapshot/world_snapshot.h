#pragma once

#include "bullet/world/world_stepper.h"
#include "polhode/bullet/snapshot.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Implement RotationControl::save_world and restore_world.
Snapshot save_world(WorldStepper& stepper);
void restore_world(WorldStepper& stepper, const Snapshot& snapshot, const WorldOrder& order);

}  // namespace POLHODE_PRECISION
}  // namespace polhode
