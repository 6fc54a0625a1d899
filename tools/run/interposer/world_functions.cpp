#include "run/interposer/world_functions.h"

#include <dlfcn.h>

#include <cstring>

#include "run/interposer/expected_bullet.h"

namespace polhode::run {

const Precision kSinglePrecision = {"single", "_ZN23btDiscreteDynamicsWorld14stepSimulationEfif",
                                    kExpectedBullet32, "libpolhode_run_float32.so"};
const Precision kDoublePrecision = {"double", "_ZN23btDiscreteDynamicsWorld14stepSimulationEdid",
                                    kExpectedBullet64, "libpolhode_run_float64.so"};

namespace {

// Searches where the linker would have searched for the library of the world's class.
void* function_beside_class_of(const char* symbol, const void* world) {
  const void* const virtual_table = *static_cast<const void* const*>(world);
  Dl_info library;
  if (dladdr(virtual_table, &library) == 0) return nullptr;
  void* const handle = dlopen(library.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
  if (handle == nullptr) return nullptr;
  void* const function = dlsym(handle, symbol);
  dlclose(handle);
  return function;
}

}  // namespace

void* function_behind(const char* symbol, const void* world) {
  void* const next = dlsym(RTLD_NEXT, symbol);
  // RTLD_NEXT does not include a Bullet that the program has loaded with dlopen and RTLD_LOCAL.
  return next != nullptr ? next : function_beside_class_of(symbol, world);
}

bool is_of_expected_bullet(const Precision& precision, const void* function) {
  if (*precision.expected_bullet == '\0') return false;
  void* const handle = dlopen(precision.expected_bullet, RTLD_LAZY | RTLD_NOLOAD);
  if (handle == nullptr) return false;
  const bool is_same = dlsym(handle, precision.step_function) == function;
  dlclose(handle);
  return is_same;
}

const char* file_of(const void* function) {
  Dl_info library;
  if (dladdr(function, &library) == 0 || library.dli_fname == nullptr) return "an unknown file";
  const char* const slash = std::strrchr(library.dli_fname, '/');
  return slash == nullptr ? library.dli_fname : slash + 1;
}

}  // namespace polhode::run
