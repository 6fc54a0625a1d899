// The library's face to the interposer.
#include "run/adapter/adapter.h"

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <exception>

#include "run/adapter/rotated_worlds.h"

namespace polhode::run {

namespace {

// Never destroyed: worlds may die after the last destructor of this library, and each tells its plugin.
RotatedWorlds* worlds = nullptr;

bool start(const char* scheme, Report report) noexcept {
  try {
    worlds = new RotatedWorlds(scheme, report);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

// Every world class derives from btDynamicsWorld alone, so the address is that of the base too.
bool before_step(void* world) noexcept {
  return worlds->before_step(*static_cast<btDynamicsWorld*>(world));
}

void after_step(std::uint64_t substeps) noexcept {
  worlds->counters().steps += substeps;
}

Counts counts() noexcept {
  return worlds->counters().read();
}

constexpr Adapter kAdapter = {start, before_step, after_step, counts};

}  // namespace

}  // namespace polhode::run

extern "C" __attribute__((visibility("default"))) const polhode::run::Adapter* polhode_run_adapter() {
  return &polhode::run::kAdapter;
}
