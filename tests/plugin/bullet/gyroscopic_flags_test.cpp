// Bullet's gyroscopic flags are cleared while Bullet solves a step of a body that the library rotates,
// because the term would count twice. At all other times the flags are the application's.
#include <gtest/gtest.h>

#include "support/both_ways.h"
#include "support/motion.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr int kExplicit = BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT;
constexpr int kImplicitWorld = BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD;
constexpr int kImplicitBody = BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;
constexpr int kEveryKind = kExplicit | kImplicitWorld | kImplicitBody;

// Combinations of flags that an application may set.
constexpr int kChoices[] = {0, kExplicit, kImplicitWorld, kImplicitBody, kEveryKind};

constexpr btScalar kDt = btScalar(1.0 / 60);

template <class Way>
class GyroscopicFlags : public ::testing::Test {
 protected:
  btRigidBody& add_tumbling() { return scene_.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4)); }

  btRigidBody& add_with_flags(int flags) {
    btRigidBody& body = add_tumbling();
    scene_.rotation().release(body);
    body.setFlags(flags);
    scene_.rotation().use_default_scheme(body);
    return body;
  }

  Way scene_;
};
TYPED_TEST_SUITE(GyroscopicFlags, BothWays, WayName);

TYPED_TEST(GyroscopicFlags, AreTheApplicationsBetweenSteps) {
  for (const int flags : kChoices) {
    btRigidBody& body = this->add_with_flags(flags | BT_DISABLE_WORLD_GRAVITY);
    for (int i = 0; i < 3; ++i) {
      ASSERT_TRUE(this->scene_.rotation().manages(body));
      EXPECT_EQ(body.getFlags(), flags | BT_DISABLE_WORLD_GRAVITY);
      this->scene_.step(kDt);
    }
    EXPECT_EQ(body.getFlags(), flags | BT_DISABLE_WORLD_GRAVITY);
  }
}

/// Records the flags of a body when the solver runs.
class WatchingSolver final : public btSequentialImpulseConstraintSolver {
 public:
  btScalar solveGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                      int manifold_count, btTypedConstraint** joints, int joint_count,
                      const btContactSolverInfo& info, btIDebugDraw* drawer,
                      btDispatcher* dispatcher) override {
    for (int i = 0; i < body_count; ++i) seen |= btRigidBody::upcast(bodies[i])->getFlags();
    ++calls;
    return btSequentialImpulseConstraintSolver::solveGroup(bodies, body_count, manifolds, manifold_count,
                                                           joints, joint_count, info, drawer, dispatcher);
  }

  int seen = 0;
  int calls = 0;
};

TYPED_TEST(GyroscopicFlags, AreOffWhileBulletSolves) {
  WatchingSolver solver;
  btConstraintSolver* const own = this->scene_.world().getConstraintSolver();
  this->scene_.world().setConstraintSolver(&solver);
  this->add_with_flags(kEveryKind | BT_DISABLE_WORLD_GRAVITY);
  this->scene_.step(kDt, 3);
  this->scene_.world().setConstraintSolver(own);
  EXPECT_EQ(solver.calls, 3);
  EXPECT_EQ(solver.seen, BT_DISABLE_WORLD_GRAVITY);
}

// The flags have no effect on managed bodies.
TYPED_TEST(GyroscopicFlags, ChangeNoBit) {
  for (const int flags : kChoices) {
    TypeParam scene;
    TypeParam other_scene;
    btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    btRigidBody& other = other_scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    for (int i = 0; i < 60; ++i) {
      body.setFlags(i % 2 == 0 ? flags : 0);
      scene.step(kDt);
      other_scene.step(kDt);
    }
    EXPECT_TRUE(same_motion(body, other)) << flags;
  }
}

// Removed from the world without telling the library.
TYPED_TEST(GyroscopicFlags, OfABodyTakenOutOfTheWorldAreAsTheyWere) {
  for (const int flags : kChoices) {
    btRigidBody& body = this->add_with_flags(flags | BT_DISABLE_WORLD_GRAVITY);
    this->scene_.step(kDt, 3);
    this->scene_.world().removeRigidBody(&body);
    EXPECT_EQ(body.getFlags(), flags | BT_DISABLE_WORLD_GRAVITY);
    this->scene_.step(kDt);
    EXPECT_EQ(body.getFlags(), flags | BT_DISABLE_WORLD_GRAVITY);
    this->scene_.world().addRigidBody(&body);
  }
}

// Moved to another world, in which Bullet rotates the body.
TYPED_TEST(GyroscopicFlags, OfABodyInAnotherWorldActThere) {
  Scene<> elsewhere;
  btRigidBody& body = this->add_with_flags(kImplicitBody);
  this->scene_.step(kDt, 3);
  this->scene_.world().removeRigidBody(&body);
  elsewhere.world().addRigidBody(&body);
  Scene<> plain;
  btRigidBody& twin = plain.add_free(btVector3(1, 2, 3), body.getAngularVelocity());
  twin.setCenterOfMassTransform(body.getWorldTransform());
  elsewhere.step(kDt, 60);
  plain.step(kDt, 60);
  EXPECT_TRUE(same(body.getAngularVelocity(), twin.getAngularVelocity()));
  elsewhere.world().removeRigidBody(&body);
  this->scene_.world().addRigidBody(&body);
}

// Removed from the world by a tick callback, within stepSimulation.
TYPED_TEST(GyroscopicFlags, OfABodyTakenOutInATickAreAsTheyWere) {
  btRigidBody& body = this->add_with_flags(kImplicitWorld);
  for (const bool before : {true, false}) {
    this->scene_.world().setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
          world->removeRigidBody(static_cast<btRigidBody*>(world->getWorldUserInfo()));
        },
        &body, before);
    this->scene_.step(kDt);
    this->scene_.world().setInternalTickCallback(nullptr, nullptr, before);
    EXPECT_EQ(body.getFlags(), kImplicitWorld);
    this->scene_.world().addRigidBody(&body);
  }
}

TYPED_TEST(GyroscopicFlags, AreGivenBackAsTheyWereOnRelease) {
  for (const int gyroscopic : kChoices) {
    for (const int other : {0, static_cast<int>(BT_DISABLE_WORLD_GRAVITY)}) {
      btRigidBody& body = this->add_with_flags(gyroscopic | other);
      this->scene_.step(kDt, 3);
      this->scene_.rotation().release(body);
      EXPECT_EQ(body.getFlags(), gyroscopic | other);
    }
  }
}

TYPED_TEST(GyroscopicFlags, AreGivenBackWhenTheDefaultSchemeIsCleared) {
  btRigidBody& body = this->add_with_flags(kImplicitWorld);
  this->scene_.rotation().clear_default_scheme();
  EXPECT_EQ(body.getFlags(), kImplicitWorld);
}

// Removed from a RotationWorld, or the plugin detached; then added or attached again.
TYPED_TEST(GyroscopicFlags, AreGivenBackWhenTheLibraryLetsGo) {
  for (const int flags : kChoices) {
    btRigidBody& body = this->add_with_flags(flags | BT_DISABLE_WORLD_GRAVITY);
    this->scene_.step(kDt);
    this->scene_.let_go(body);
    EXPECT_EQ(body.getFlags(), flags | BT_DISABLE_WORLD_GRAVITY);
    this->scene_.take_back(body);
    this->scene_.step(kDt);
    EXPECT_EQ(body.getFlags(), flags | BT_DISABLE_WORLD_GRAVITY);
  }
}

TYPED_TEST(GyroscopicFlags, SurviveAChangeOfScheme) {
  btRigidBody& body = this->add_with_flags(kExplicit);
  this->scene_.rotation().set_scheme(body, "quaternion");
  this->scene_.step(kDt);
  this->scene_.rotation().set_scheme(body, "matrix");
  this->scene_.step(kDt);
  EXPECT_EQ(body.getFlags(), kExplicit);
  this->scene_.rotation().release(body);
  EXPECT_EQ(body.getFlags(), kExplicit);
}

TYPED_TEST(GyroscopicFlags, OfBodiesNotManagedStay) {
  btRigidBody& released = this->add_tumbling();
  this->scene_.rotation().release(released);
  btRigidBody& fixed = this->scene_.add_floor();
  btRigidBody& kinematic = this->scene_.add_kinematic(
      btTransform(btQuaternion::getIdentity(), btVector3(0, 30, 0)), 1, btVector3(1, 2, 3));
  this->scene_.step(kDt, 3);
  for (const btRigidBody* body : {&released, &fixed, &kinematic}) EXPECT_EQ(body->getFlags(), kImplicitBody);
}

}  // namespace
}  // namespace polhode::testing
