#pragma once

namespace polhode::run {

/// Names that differ between the two precisions of Bullet.
struct Precision {
  const char* name;
  const char* step_function;  ///< btDiscreteDynamicsWorld::stepSimulation, which every rotatable world calls
  const char* expected_bullet;  ///< shared library to which the adapter is linked; empty without an adapter
  const char* adapter_file;
};

extern const Precision kSinglePrecision;
extern const Precision kDoublePrecision;

/// Returns the function that the program would call without the interposer, or null.
void* function_behind(const char* symbol, const void* world);

/// Returns true if the function belongs to the Bullet to which the adapter is linked.
bool is_of_expected_bullet(const Precision& precision, const void* function);

/// Returns the name of the file that contains a function, without its folder.
const char* file_of(const void* function);

}  // namespace polhode::run
