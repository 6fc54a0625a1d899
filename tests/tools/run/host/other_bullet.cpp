#include "tools/run/host/other_bullet.h"

btDiscreteDynamicsWorld::~btDiscreteDynamicsWorld() = default;

int btDiscreteDynamicsWorld::stepSimulation(float /*dt*/, int most_substeps, float /*fixed_dt*/) {
  return most_substeps;
}
