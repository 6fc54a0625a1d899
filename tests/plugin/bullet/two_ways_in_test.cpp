// RotationWorld and RotationPlugin give the same bits on each supported kind of world.
#include <gtest/gtest.h>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/precision.h"
#include "support/same_body_bits.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

// Spinning boxes of several shapes and schemes that fall into a pile, with friction.
template <class World>
void add_pile(Scene<World>& scene) {
  scene.world().setGravity(btVector3(0, 0, -10));
  scene.add_floor();
  for (int i = 0; i < 12; ++i) {
    const auto level = static_cast<btScalar>(i);
    const btVector3 half_extents(btScalar(0.2), btScalar(0.3) + level / 40, btScalar(0.5));
    const btVector3 origin(level / 20, -level / 30, 1 + level * btScalar(1.2));
    btRigidBody& box = scene.add_box(half_extents, 1 + level / 4,
                                     btTransform(btQuaternion(1, 2, level, 4).normalized(), origin));
    box.setAngularVelocity(btVector3(3, level - 6, 5));
    box.setFriction(btScalar(0.6));
  }
}

void choose_schemes(RotationControl& rotation, const std::vector<std::unique_ptr<btRigidBody>>& bodies) {
  // The other bodies keep the default scheme. `matrix` swells until it is stopped.
  const auto& schemes = built_in_schemes();
  for (std::size_t i = 1; i < bodies.size(); i += 2) {
    rotation.set_scheme(*bodies[i], schemes[i / 2 % schemes.size()]);
  }
}

template <class World, class OtherWorld>
int first_step_that_differs(Scene<World>& scene, Scene<OtherWorld>& other, btScalar dt, int steps) {
  for (int step = 1; step <= steps; ++step) {
    scene.step(dt);
    other.step(dt);
    for (std::size_t i = 0; i < scene.bodies().size(); ++i) {
      if (!same_bits(*scene.bodies()[i], *other.bodies()[i])) return step;
    }
  }
  return 0;
}

template <class World>
class BothWaysIn : public ::testing::Test {};

using Worlds = ::testing::Types<btDiscreteDynamicsWorld, btDiscreteDynamicsWorldMt, btSoftRigidDynamicsWorld,
                                btMultiBodyDynamicsWorld>;
TYPED_TEST_SUITE(BothWaysIn, Worlds);

TYPED_TEST(BothWaysIn, GiveTheSameBitsOverTenThousandStepsOfAPile) {
  Scene<RotationWorld<TypeParam>> subclassed;
  add_pile(subclassed);
  choose_schemes(subclassed.world().rotation(), subclassed.bodies());

  Scene<TypeParam> attached;
  RotationPlugin plugin(attached.world());
  add_pile(attached);
  choose_schemes(plugin.rotation(), attached.bodies());

  EXPECT_EQ(first_step_that_differs(subclassed, attached, btScalar(1.0 / 240.0), 10000), 0);
  EXPECT_EQ(plugin.rotation().incidents(), subclassed.world().rotation().incidents());
}

TYPED_TEST(BothWaysIn, GiveTheSameBitsInFreeFlightForEveryScheme) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    Scene<RotationWorld<TypeParam>> subclassed;
    subclassed.world().rotation().set_default_scheme(scheme);
    subclassed.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));

    Scene<TypeParam> attached;
    RotationPlugin plugin(attached.world());
    plugin.rotation().set_default_scheme(scheme);
    attached.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));

    // Up to the divergence of `matrix`, and beyond.
    EXPECT_EQ(first_step_that_differs(subclassed, attached, btScalar(1.0 / 60.0), 2000), 0)
        << scheme->description().name;
  }
}

TYPED_TEST(BothWaysIn, GiveBulletsBitsIfEveryBodyIsReleased) {
  Scene<TypeParam> plain;
  add_pile(plain);

  Scene<RotationWorld<TypeParam>> subclassed;
  subclassed.world().rotation().clear_default_scheme();
  add_pile(subclassed);
  EXPECT_EQ(subclassed.world().rotation().managed_bodies(), 0u);
  EXPECT_EQ(first_step_that_differs(subclassed, plain, btScalar(1.0 / 240.0), 2000), 0);

  Scene<TypeParam> plain_again;
  add_pile(plain_again);
  Scene<TypeParam> attached;
  RotationPlugin plugin(attached.world());
  add_pile(attached);
  for (const auto& body : attached.bodies()) plugin.rotation().release(*body);
  EXPECT_EQ(first_step_that_differs(attached, plain_again, btScalar(1.0 / 240.0), 2000), 0);
}

}  // namespace
}  // namespace polhode::testing
