#include <vector>

#include "polhode/bullet/rotation_world.h"
#include "soak/soak_run.h"
#include "soak/watched_body.h"
#include "support/motion.h"
#include "support/scene.h"

namespace polhode::testing {

namespace {

constexpr int kFreeBodies = 8;

}  // namespace

bool soak_small_world(std::int64_t steps) {
  SoakRun run("small world", steps, 0);  // the heap must keep its size to the byte
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  for (int i = 0; i < kFreeBodies; ++i) {
    scene.add_free(vector(1, 1.5 + 0.1 * i, 2.2), vector(0.3 + i, 2, 0.1 - 0.2 * i));
  }
  // Two boxes on a platform, and a rod on a hinge.
  scene.add(0, vector(0, 0, 0), btTransform(btQuaternion::getIdentity(), vector(0, 50, 0)),
            scene.box(vector(5, 5, 1)));
  for (const double height : {1.5, 2.6}) {
    scene.add_box(vector(0.4, 0.3, 0.5), 1, btTransform(btQuaternion::getIdentity(), vector(0.1, 50, height)))
        .setGravity(vector(0, 0, -9.81));
  }
  btRigidBody& rod = scene.add_free(vector(1, 0.1, 1), vector(0, 0, 5));
  scene.join<btHingeConstraint>(rod, vector(0, 0, 0), vector(0, 0, 1));
  std::vector<WatchedBody> watched;
  for (std::int64_t step = 1; step <= run.steps(); ++step) {
    scene.step(btScalar(1.0 / 60));
    if (step == 1) {
      for (int i = 0; i < kFreeBodies; ++i) watched.emplace_back(rotation.rotation_of(*scene.bodies()[i]));
    }
    if (!run.is_checkpoint(step)) continue;
    Drift drift;
    for (int i = 0; i < kFreeBodies; ++i) {
      watched[i].add_drift(rotation.rotation_of(*scene.bodies()[i]), drift);
    }
    for (const auto& body : scene.bodies()) {
      if (body->isStaticObject()) continue;
      run.require(rotation.rotation_of(*body).steps == static_cast<std::uint64_t>(step), step, "steps");
      run.require(!rotation.rotation_of(*body).diverged, step, "a body diverged");
    }
    run.require(rotation.managed_bodies() == scene.bodies().size() - 1, step, "managed bodies");
    run.require(rotation.incidents() == 0, step, "an incident");
    run.check(step, drift, rotation.managed_bodies());
  }
  return run.passed();
}

}  // namespace polhode::testing
