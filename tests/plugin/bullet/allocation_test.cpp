// A step allocates nothing after warm-up.
#include <gtest/gtest.h>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/counted_heap.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

TEST(Step, AllocatesNothingAfterWarmUp) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> subclassed;
  Scene<> attached;
  RotationPlugin plugin(attached.world());
  for (const SchemePointer& scheme : built_in_schemes()) {
    btRigidBody& in_world = subclassed.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    btRigidBody& with_plugin = attached.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    subclassed.world().rotation().set_scheme(in_world, scheme);
    plugin.rotation().set_scheme(with_plugin, scheme);
  }
  const auto drive = [](RotationControl& rotation, btRigidBody& body) {
    rotation.set_torque_law(body, [](const TorqueLawInput& motion) { return WorldTorque{-motion.omega_W}; });
    rotation.set_rotor_momentum(body, {0.0, 0.5, 1.0}, RotorChange::by_motor);
    rotation.set_rotor_torque(body, {0.0, 0.0, 0.1});
  };
  drive(subclassed.world().rotation(), subclassed.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4)));
  drive(plugin.rotation(), attached.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4)));
  const auto step = [&](int count) {
    subclassed.step(btScalar(1.0 / 60.0), count);
    attached.step(btScalar(1.0 / 60.0), count);
  };
  step(3);
  const std::size_t before = heap_allocations();
  step(50);
  EXPECT_EQ(heap_allocations(), before);
}

}  // namespace
}  // namespace polhode::testing
