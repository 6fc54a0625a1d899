#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <string>

namespace polhode::run {

/// Returns the demangled name of the world's class.
std::string readable_type_name(const btDynamicsWorld& world);

/// Returns true if the program's own copy of the library rotates the world, by a RotationWorld or a
/// RotationPlugin. That copy has its own list of rotated worlds, so this checks the names of classes.
bool is_rotated_by_the_program(const btDynamicsWorld& world);

}  // namespace polhode::run
