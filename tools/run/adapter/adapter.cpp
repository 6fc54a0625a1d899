// The library's face to the interposer.
#include "run/adapter/adapter.h"

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include "run/adapter/rotated_worlds.h"

namespace polhode::run {

namespace {

// Never destroyed: worlds may die after the last destructor of this library, and each tells its plugin.
RotatedWorlds* worlds = nullptr;

void start(const char* scheme, Report report) noexcept {
  worlds = new RotatedWorlds(scheme, report);
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

}  // namespace

}  // namespace polhode::run

extern "C" __attribute__((visibility("default"))) const polhode::run::Adapter* polhode_run_adapter() {
  static constexpr polhode::run::Adapter kAdapter = {polhode::run::start, polhode::run::before_step,
                                                     polhode::run::after_step, polhode::run::counts};
  return &kAdapter;
}
