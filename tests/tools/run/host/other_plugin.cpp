// A simulator plugin that contains another Bullet. Returns the results of its steps.
#include "tools/run/host/other_bullet.h"

extern "C" __attribute__((visibility("default"))) double step_hidden_world() {
  btDiscreteDynamicsWorld object;
  btDiscreteDynamicsWorld* volatile world = &object;
  return world->stepSimulation(1.0f, 3, 1.0f) + world->stepSimulation(1.0f, 4, 1.0f);
}
