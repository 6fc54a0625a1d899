#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <string>

namespace polhode::run {

/// Returns the name of the world's class as its source has it.
std::string readable_type_name(const btDynamicsWorld& world);

/// Returns true if the world is a RotationWorld, or has a RotationPlugin, of the program's own copy of the
/// library. That copy keeps its own list of rotated worlds, so the names of the classes have to tell.
bool is_rotated_by_the_program(const btDynamicsWorld& world);

}  // namespace polhode::run
