// A program that steps a world of another Bullet twice and returns the results of the steps.
#include "tools/run/host/other_bullet.h"

int main() {
  btDiscreteDynamicsWorld object;
  btDiscreteDynamicsWorld* volatile world = &object;  // prevents devirtualization
  return world->stepSimulation(1.0f, 3, 1.0f) + world->stepSimulation(1.0f, 4, 1.0f);
}
