// Replaces Bullet's stepSimulation in a program that was started with this library in LD_PRELOAD: the dynamic
// linker fills Bullet's virtual tables with the functions below.
#include <cstdint>
#include <cstdlib>

#include "run/interposer/report.h"
#include "run/interposer/rotation.h"

namespace polhode::run {

namespace {

// Bullet returns the number of substeps that were due. It takes at most `most` of them; for 0 it takes one of
// variable length.
std::uint64_t substeps_taken(int due, int most) {
  const int taken = most > 0 && due > most ? most : due;
  return taken > 0 ? static_cast<std::uint64_t>(taken) : 0;
}

template <class Scalar>
int step(const char* symbol, void* world, Scalar dt, int most_substeps, Scalar fixed_dt) {
  Rotation& rotation = rotation_in(sizeof(Scalar) == sizeof(double) ? 1 : 0);
  const bool is_rotated = rotation.before_step(world);
  const auto bullets = reinterpret_cast<int (*)(void*, Scalar, int, Scalar)>(function_behind(symbol, world));
  if (bullets == nullptr) {
    report("Bullet's own stepSimulation cannot be found, so the program cannot continue");
    std::abort();
  }
  const int due = bullets(world, dt, most_substeps, fixed_dt);
  if (is_rotated) rotation.after_step(substeps_taken(due, most_substeps));
  return due;
}

}  // namespace

}  // namespace polhode::run

// Uses the linker's names of Bullet's functions, since Bullet's headers support only one precision. The world
// comes first, where the Itanium C++ ABI passes `this`.
#define POLHODE_RUN_STEP(function, Scalar, symbol)                                        \
  extern "C" __attribute__((visibility("default"))) int function(void*, Scalar, int,      \
                                                                 Scalar) __asm__(symbol); \
  int function(void* world, Scalar dt, int most_substeps, Scalar fixed_dt) {              \
    return polhode::run::step<Scalar>(symbol, world, dt, most_substeps, fixed_dt);        \
  }

POLHODE_RUN_STEP(step_discrete32, float, "_ZN23btDiscreteDynamicsWorld14stepSimulationEfif")
POLHODE_RUN_STEP(step_discrete64, double, "_ZN23btDiscreteDynamicsWorld14stepSimulationEdid")
// These two worlds do not call the function above and cannot be rotated, which is reported to the user.
POLHODE_RUN_STEP(step_deformable32, float, "_ZN34btDeformableMultiBodyDynamicsWorld14stepSimulationEfif")
POLHODE_RUN_STEP(step_deformable64, double, "_ZN34btDeformableMultiBodyDynamicsWorld14stepSimulationEdid")
POLHODE_RUN_STEP(step_simple32, float, "_ZN21btSimpleDynamicsWorld14stepSimulationEfif")
POLHODE_RUN_STEP(step_simple64, double, "_ZN21btSimpleDynamicsWorld14stepSimulationEdid")
