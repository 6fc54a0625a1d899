// A simulator plugin with its own Bullet, such as a physics engine.
#include "tools/run/host/scene.h"

extern "C" __attribute__((visibility("default"))) double step_hidden_world() {
  polhode::run_test::TumblingWorld world;
  for (int i = 0; i < polhode::run_test::kSteps; ++i) world.step();
  return world.energy_ratio();
}
