// A world that the application created keeps its own settings. Worlds that cannot be hooked are refused with
// a clear message.
#include <BulletDynamics/Dynamics/btSimpleDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <type_traits>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

using ::testing::HasSubstr;

constexpr btScalar kDt = btScalar(1.0 / 60.0);

template <class Function>
std::string message_of(Function function) {
  try {
    function();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing was thrown";
}

// An application's world that uses both tick callbacks and the user pointer.
struct Ticks {
  int before = 0;
  int after = 0;
};

void count_before(btDynamicsWorld* world, btScalar /*dt*/) {
  ++static_cast<Ticks*>(world->getWorldUserInfo())->before;
}
void count_after(btDynamicsWorld* world, btScalar /*dt*/) {
  ++static_cast<Ticks*>(world->getWorldUserInfo())->after;
}

TEST(ApplicationsWorld, KeepsItsCallbacksUserPointerSolverAndActions) {
  Scene<> scene;
  Ticks ticks;
  scene.world().setInternalTickCallback(count_before, &ticks, true);
  scene.world().setInternalTickCallback(count_after, &ticks, false);
  btConstraintSolver* const solver = scene.world().getConstraintSolver();
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  int owner = 0;
  body.setUserPointer(&owner);
  body.setUserIndex(42);
  {
    RotationPlugin plugin(scene.world());
    scene.world().stepSimulation(3 * kDt + kDt / 2, 5, kDt);
    EXPECT_EQ(plugin.rotation().rotation_of(body).steps, 3u);
  }
  scene.step(kDt);
  EXPECT_EQ(ticks.before, 4);
  EXPECT_EQ(ticks.after, 4);
  EXPECT_EQ(scene.world().getWorldUserInfo(), &ticks);
  EXPECT_EQ(scene.world().getConstraintSolver(), solver);
  EXPECT_EQ(body.getUserPointer(), &owner);
  EXPECT_EQ(body.getUserIndex(), 42);
}

TEST(ApplicationsWorld, MayBeASubclassOfItsOwn) {
  struct Own : btDiscreteDynamicsWorld {
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
    void integrateTransforms(btScalar dt) override {
      ++calls;
      btDiscreteDynamicsWorld::integrateTransforms(dt);
    }
    int calls = 0;
  };
  Scene<RotationWorld<Own>> scene;
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  scene.step(kDt, 3);
  EXPECT_EQ(scene.world().calls, 3);
  EXPECT_EQ(scene.world().rotation().rotation_of(body).steps, 3u);
}

// Overrides one overload of addRigidBody and so hides the other, like Bullet's btFractureDynamicsWorld.
class OverridesOneAdd : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
  void addRigidBody(btRigidBody* body) override {
    ++added;
    btDiscreteDynamicsWorld::addRigidBody(body);
  }
  int added = 0;
};

class OverridesTheOtherAdd : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
  void addRigidBody(btRigidBody* body, int group, int mask) override {
    ++added;
    btDiscreteDynamicsWorld::addRigidBody(body, group, mask);
  }
  int added = 0;
};

template <class World>
class WorldThatOverridesOneAdd : public ::testing::Test {};
using WorldsThatOverrideOneAdd = ::testing::Types<OverridesOneAdd, OverridesTheOtherAdd>;
TYPED_TEST_SUITE(WorldThatOverridesOneAdd, WorldsThatOverrideOneAdd);

TYPED_TEST(WorldThatOverridesOneAdd, HasBodiesAddedInEitherWayRotated) {
  Scene<RotationWorld<TypeParam>> scene;
  btRigidBody& one = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  btRigidBody& other = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  scene.world().removeRigidBody(&other);
  btDiscreteDynamicsWorld& base = scene.world();
  base.addRigidBody(&other, 1, -1);
  EXPECT_EQ(scene.world().rotation().managed_bodies(), 2u);
  EXPECT_EQ(scene.world().added, (std::is_same_v<TypeParam, OverridesOneAdd> ? 2 : 1));
  scene.step(kDt, 3);
  EXPECT_EQ(scene.world().rotation().rotation_of(one).steps, 3u);
  EXPECT_EQ(scene.world().rotation().rotation_of(other).steps, 3u);
}

TEST(RefusedWorld, SimpleDynamicsWorldSaysWhichAreValid) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSimpleDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  const std::string message = message_of([&] { RotationPlugin plugin(world); });
  EXPECT_THAT(message, HasSubstr("cannot be rotated"));
  EXPECT_THAT(message, HasSubstr("btDiscreteDynamicsWorld"));
}

TEST(RefusedBody, LinkOfAMultiBodySaysSo) {
  Scene<RotationWorld<btMultiBodyDynamicsWorld>> scene;
  btMultiBody multi_body(1, 10, btVector3(1, 1, 1), false, false);
  btMultiBodyLinkCollider link(&multi_body, 0);
  EXPECT_THAT(message_of([&] { scene.world().rotation().set_scheme(link, "matrix"); }),
              HasSubstr("btMultiBody"));
}

TEST(RefusedBody, StaticBodySaysSo) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  btRigidBody& floor = scene.add_floor();
  EXPECT_THAT(message_of([&] { scene.world().rotation().set_scheme(floor, "matrix"); }), HasSubstr("static"));
  EXPECT_THAT(message_of([&] { scene.world().rotation().rotation_of(floor); }), HasSubstr("static"));
}

TEST(RefusedScheme, SaysWhatIsValidAndChangesNothing) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  rotation.set_scheme(body, "matrix");
  EXPECT_THAT(message_of([&] { rotation.set_scheme(body, "matrx"); }),
              HasSubstr("valid are exact, matrix, quaternion"));
  EXPECT_THAT(message_of([&] { rotation.set_scheme(body, SchemePointer()); }), HasSubstr("null"));
  EXPECT_THAT(message_of([&] { rotation.set_default_scheme("matrx"); }),
              HasSubstr("valid are exact, matrix, quaternion"));
  EXPECT_THAT(message_of([&] { rotation.set_default_scheme(SchemePointer()); }),
              HasSubstr("clear_default_scheme"));
  EXPECT_EQ(rotation.rotation_of(body).scheme, "matrix");
}

}  // namespace
}  // namespace polhode::testing
