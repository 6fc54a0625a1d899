#pragma once

namespace polhode::run {

/// What differs between the two precisions of Bullet, as the linker names it.
struct Precision {
  const char* name;
  const char* step_function;  ///< btDiscreteDynamicsWorld::stepSimulation, which every rotatable world calls
  const char*
      expected_bullet;  ///< the shared library that the adapter is linked to; empty without an adapter
  const char* adapter_file;
};

extern const Precision kSinglePrecision;
extern const Precision kDoublePrecision;

/// Returns the function that the program would call if the interposer were not there, or null.
void* function_behind(const char* symbol, const void* world);

/// Returns true if the function is of the Bullet that the adapter is linked to.
bool is_of_expected_bullet(const Precision& precision, const void* function);

/// Returns the file that a function is in, without its folder.
const char* file_of(const void* function);

}  // namespace polhode::run
