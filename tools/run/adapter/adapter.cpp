// The adapter library's interface to the interposer.
#include "run/adapter/adapter.h"

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <exception>

#include "run/adapter/rotated_worlds.h"

namespace polhode::run {

namespace {

// Never destroyed: worlds may be destroyed after the last destructor of this library, and notify their
// plugins.
RotatedWorlds* worlds = nullptr;

bool start(const char* scheme, Report report) noexcept {
  try {
    worlds = new RotatedWorlds(scheme, report);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

// btDynamicsWorld is the only base of every world class, so the address is also that of the base.
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
