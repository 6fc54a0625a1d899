// Bullet has one pre-tick callback, one tick callback and one user pointer. Like many engines, this
// application uses all three. Polhode works without them.
#include <polhode/bullet/rotation_plugin.h>

#include "consumer.h"

namespace {

struct Application {
  int ticks_begun = 0;
  int ticks_ended = 0;
};

Application& application_of(btDynamicsWorld* world) {
  return *static_cast<Application*>(world->getWorldUserInfo());
}

}  // namespace

void rotates_a_world_whose_callbacks_and_user_pointer_are_taken() {
  WorldParts parts;
  btDiscreteDynamicsWorld world(&parts.dispatcher, &parts.broadphase, &parts.solver, &parts.configuration);
  Application application;
  world.setInternalTickCallback([](btDynamicsWorld* w, btScalar) { ++application_of(w).ticks_begun; },
                                &application, true);
  world.setInternalTickCallback([](btDynamicsWorld* w, btScalar) { ++application_of(w).ticks_ended; },
                                &application, false);
  world.addRigidBody(&parts.body);

  {
    polhode::RotationPlugin plugin(world);
    plugin.rotation().set_scheme(parts.body, "matrix");
    for (int frame = 0; frame < 10; ++frame) world.stepSimulation(btScalar(1) / 60, 4, btScalar(1) / 240);

    REQUIRE(application.ticks_begun == 40);
    REQUIRE(application.ticks_ended == 40);
    REQUIRE(world.getWorldUserInfo() == &application);
    REQUIRE(plugin.rotation().rotation_of(parts.body).steps == 40);
    // None of Bullet's own ways of rotation swells a body; the scheme `matrix` does.
    REQUIRE(plugin.rotation().rotation_of(parts.body).state.R_WB.determinant() > 1.001);
  }

  world.stepSimulation(btScalar(1) / 240, 1, btScalar(1) / 240);
  REQUIRE(application.ticks_begun == 41);
  REQUIRE(application.ticks_ended == 41);
  REQUIRE(world.getWorldUserInfo() == &application);
  world.removeRigidBody(&parts.body);
}
