// A program that uses the library itself: rotating_host world|plugin|derived.
#include <cstdio>
#include <memory>
#include <string>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "tools/run/host/scene.h"

namespace {

using namespace polhode::run_test;
using World = polhode::RotationWorld<btDiscreteDynamicsWorld>;

class DerivedWorld : public World {
 public:
  using World::World;
};

double step(btDiscreteDynamicsWorld& world) {
  TumblingBody body;
  world.setGravity(btVector3(0, 0, 0));
  world.addRigidBody(&body.body());
  for (int i = 0; i < kSteps; ++i) world.stepSimulation(kDt, 0);
  world.removeRigidBody(&body.body());
  return body.energy_ratio();
}

double step_with_plugin() {
  TumblingWorld world;
  polhode::RotationPlugin plugin(world.world());
  for (int i = 0; i < kSteps; ++i) world.step();
  return world.energy_ratio();
}

template <class WorldType>
double step_world() {
  Surroundings surroundings;
  WorldType world(&surroundings.dispatcher, &surroundings.broadphase, &surroundings.solver,
                  &surroundings.configuration);
  return step(world);
}

}  // namespace

int main(int argument_count, char** arguments) {
  const std::string what = argument_count > 1 ? arguments[1] : "";
  const double ratio = what == "plugin"    ? step_with_plugin()
                       : what == "derived" ? step_world<DerivedWorld>()
                                           : step_world<World>();
  std::printf("energy ratio %.17g\n", ratio);
  return 0;
}
