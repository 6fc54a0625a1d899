// A program that steps a world of another Bullet twice, and returns what the steps return.
#include "tools/run/host/other_bullet.h"

int main() {
  btDiscreteDynamicsWorld object;
  btDiscreteDynamicsWorld* volatile world = &object;  // called by the virtual table, as programs do
  return world->stepSimulation(1.0f, 3, 1.0f) + world->stepSimulation(1.0f, 4, 1.0f);
}
