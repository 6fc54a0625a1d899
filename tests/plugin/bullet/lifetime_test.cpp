// Bodies come and go, plugins attach and detach, and worlds are deleted in any order that Bullet allows.
#include <gtest/gtest.h>

#include <limits>
#include <new>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/precision.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60.0);
constexpr int kBornWith = BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;
const btVector3 kInertia(1, 2, 3);

// Creates two bodies one after the other at the same address.
class ReusedAddress : public ::testing::Test {
 protected:
  ~ReusedAddress() override {
    if (body_ != nullptr) body_->~btRigidBody();
  }

  btRigidBody& make() {
    if (body_ != nullptr) body_->~btRigidBody();
    body_ = new (room_) btRigidBody(1, nullptr, &shape_, kInertia);
    body_->setActivationState(DISABLE_DEACTIVATION);
    return *body_;
  }

  btSphereShape shape_{1};
  alignas(btRigidBody) std::byte room_[sizeof(btRigidBody)];
  btRigidBody* body_ = nullptr;
};

TEST_F(ReusedAddress, GivesNothingOfTheOldBodyToTheNewInAPlugin) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  btRigidBody& old_body = make();
  scene.world().addRigidBody(&old_body);
  plugin.rotation().set_scheme(old_body, "quaternion");
  old_body.setAngularVelocity(btVector3(3, 2, 4));
  scene.step(kDt, 10);
  scene.world().removeRigidBody(&old_body);

  btRigidBody& new_body = make();
  EXPECT_FALSE(plugin.rotation().manages(new_body));
  scene.world().addRigidBody(&new_body);
  scene.step(kDt);
  const BodyRotation rotation = plugin.rotation().rotation_of(new_body);
  EXPECT_EQ(rotation.scheme, default_scheme()->description().name);
  EXPECT_EQ(rotation.steps, 1u);
  EXPECT_EQ(rotation.state.omega_W, Vector3::Zero());
  EXPECT_EQ(rotation.state.L_W, Vector3::Zero());
  EXPECT_EQ(new_body.getWorldTransform().getBasis(), btMatrix3x3::getIdentity());
  plugin.rotation().release(new_body);
  EXPECT_EQ(new_body.getFlags(), kBornWith);
  scene.world().removeRigidBody(&new_body);
}

TEST_F(ReusedAddress, OfAReleasedBodyIsManagedAgain) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  btRigidBody& old_body = make();
  scene.world().addRigidBody(&old_body);
  plugin.rotation().release(old_body);
  scene.step(kDt, 3);
  scene.world().removeRigidBody(&old_body);

  btRigidBody& new_body = make();
  scene.world().addRigidBody(&new_body);
  EXPECT_TRUE(plugin.rotation().manages(new_body));
  scene.step(kDt);
  EXPECT_EQ(plugin.rotation().rotation_of(new_body).steps, 1u);
  scene.world().removeRigidBody(&new_body);
}

TEST_F(ReusedAddress, HasTheNewBodysRotationBeforeTheFirstStep) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  btRigidBody& old_body = make();
  scene.world().addRigidBody(&old_body);
  old_body.setAngularVelocity(btVector3(3, 2, 4));
  scene.step(kDt, 3);
  scene.world().removeRigidBody(&old_body);

  btRigidBody& new_body = make();
  scene.world().addRigidBody(&new_body);
  EXPECT_EQ(plugin.rotation().rotation_of(new_body).steps, 0u);
  EXPECT_EQ(plugin.rotation().rotation_of(new_body).state.omega_W, Vector3::Zero());
  scene.world().removeRigidBody(&new_body);
}

// The last body of a scheme moves into the lane of the removed one after its own step has begun.
TEST_F(ReusedAddress, LeavesNoHoleThatIsStepped) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  btRigidBody& other = scene.add_free(btVector3(1, 2, 3), btVector3(1, 2, 3));
  btRigidBody& old_body = make();
  scene.world().addRigidBody(&old_body);
  plugin.rotation().set_scheme(old_body, "matrix");
  plugin.rotation().set_scheme(other, "matrix");
  scene.step(kDt, 3);
  scene.world().removeRigidBody(&old_body);

  btRigidBody& new_body = make();
  scene.world().addRigidBody(&new_body);
  scene.step(kDt, 3);
  EXPECT_EQ(plugin.rotation().rotation_of(other).scheme, "matrix");
  EXPECT_EQ(plugin.rotation().rotation_of(other).steps, 6u);
  EXPECT_EQ(plugin.rotation().rotation_of(new_body).scheme, "exact");
  EXPECT_EQ(plugin.rotation().rotation_of(new_body).steps, 3u);
  scene.world().removeRigidBody(&new_body);
}

// The handler deletes a second body whose incident has not been reported yet.
TEST(Incidents, AreNotReportedForBodiesThatTheHandlerRemovedBefore) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  btRigidBody& first = scene.add_free(btVector3(1, 2, 3), btVector3(1, 2, 3));
  btRigidBody& second = scene.add_free(btVector3(1, 2, 3), btVector3(1, 2, 3));
  scene.step(kDt, 3);
  int told = 0;
  scene.world().rotation().set_incident_handler([&](const Incident& incident) {
    ++told;
    if (incident.body == &first) scene.remove(second);
  });
  for (btRigidBody* body : {&first, &second}) {
    body->setAngularVelocity(btVector3(std::numeric_limits<btScalar>::quiet_NaN(), 0, 0));
  }
  scene.step(kDt, 2);
  EXPECT_EQ(told, 1);
}

TEST_F(ReusedAddress, GivesNothingOfTheOldBodyToTheNewInARotationWorld) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  btRigidBody& old_body = make();
  scene.world().addRigidBody(&old_body);
  scene.world().rotation().set_scheme(old_body, "matrix");
  old_body.setAngularVelocity(btVector3(3, 2, 4));
  scene.step(kDt, 10);
  scene.world().removeRigidBody(&old_body);

  btRigidBody& new_body = make();
  new_body.setAngularVelocity(btVector3(0, 1, 0));
  scene.world().addRigidBody(&new_body);
  scene.step(kDt);
  const BodyRotation rotation = scene.world().rotation().rotation_of(new_body);
  EXPECT_EQ(rotation.scheme, default_scheme()->description().name);
  EXPECT_EQ(rotation.steps, 1u);
  EXPECT_LE((rotation.state.omega_W - Vector3(0, 1, 0)).norm(), 1e-15);  // measured 2.2e-16
  scene.world().removeRigidBody(&new_body);
}

TEST(RemovedBody, KeepsItsChoiceWhenAddedAgainBeforeTheNextStep) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  btRigidBody& body = scene.add_free(kInertia, btVector3(3, 2, 4));
  rotation.set_scheme(body, "matrix");
  scene.step(kDt);
  scene.world().removeRigidBody(&body);
  EXPECT_EQ(body.getFlags(), kBornWith);
  EXPECT_FALSE(rotation.manages(body));
  scene.world().addRigidBody(&body);
  EXPECT_EQ(rotation.rotation_of(body).scheme, "matrix");
}

TEST(RemovedBody, IsForgottenByAStepWithoutIt) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  btRigidBody& body = scene.add_free(kInertia, btVector3(3, 2, 4));
  plugin.rotation().set_scheme(body, "matrix");
  scene.step(kDt);
  scene.world().removeRigidBody(&body);
  scene.step(kDt);
  EXPECT_EQ(plugin.rotation().managed_bodies(), 0u);
  scene.world().addRigidBody(&body);
  scene.step(kDt);
  EXPECT_EQ(plugin.rotation().rotation_of(body).scheme, default_scheme()->description().name);
}

// Between detach and attach the plugin does nothing: Bullet rotates the body, which has its own flags again.
TEST(DetachedPlugin, LeavesTheWorldToBulletAndGoesOnWhenAttachedAgain) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  btRigidBody& body = scene.add_free(kInertia, btVector3(3, 2, 4));
  plugin.rotation().set_scheme(body, "quaternion");
  scene.step(kDt, 100);

  plugin.detach();
  plugin.detach();
  EXPECT_FALSE(plugin.attached());
  EXPECT_EQ(body.getFlags(), kBornWith);
  Scene<> plain;
  btRigidBody& twin = plain.add_free(kInertia, body.getAngularVelocity(), body.getOrientation());
  twin.setWorldTransform(body.getWorldTransform());
  twin.updateInertiaTensor();
  scene.step(kDt, 100);
  plain.step(kDt, 100);
  EXPECT_EQ(body.getWorldTransform().getBasis(), twin.getWorldTransform().getBasis());

  plugin.attach();
  plugin.attach();
  EXPECT_EQ(body.getFlags(), kBornWith);
  const BodyRotation taken_on = plugin.rotation().rotation_of(body);
  EXPECT_EQ(taken_on.scheme, "quaternion");
  EXPECT_EQ(taken_on.steps, 0u);
  scene.step(kDt, 100);
  const BodyRotation later = plugin.rotation().rotation_of(body);
  EXPECT_EQ(later.steps, 100u);
  // `quaternion` keeps L; measured 0
  EXPECT_LE((later.state.L_W - taken_on.state.L_W).norm(), 1e-14 * taken_on.state.L_W.norm());
}

TEST(PluginLifetime, EndsBeforeTheWorldAndLeavesFlagsAsTheyWere) {
  Scene<> scene;
  btRigidBody& body = scene.add_free(kInertia, btVector3(3, 2, 4));
  {
    const RotationPlugin plugin(scene.world());
    scene.step(kDt);
  }
  EXPECT_EQ(body.getFlags(), kBornWith);
  scene.step(kDt);
}

TEST(PluginLifetime, AllowsASecondPluginOnlyAfterTheFirst) {
  Scene<> scene;
  RotationPlugin first(scene.world());
  EXPECT_THROW(RotationPlugin second(scene.world()), std::invalid_argument);
  first.detach();
  {
    RotationPlugin second(scene.world());
    EXPECT_THROW(first.attach(), std::invalid_argument);
    EXPECT_FALSE(first.attached());
  }
  EXPECT_NO_THROW(first.attach());
  Scene<RotationWorld<btDiscreteDynamicsWorld>> subclassed;
  EXPECT_THROW(RotationPlugin on_top(subclassed.world()), std::invalid_argument);
}

TEST(PluginLifetime, SurvivesAThrowingConstructorWithTheWorldUntouched) {
  Scene<> scene;
  btRigidBody& body = scene.add_free(kInertia, btVector3(3, 2, 4));
  const RotationPlugin first(scene.world());
  EXPECT_THROW(RotationPlugin second(scene.world()), std::invalid_argument);
  scene.step(kDt, 2);
  EXPECT_EQ(first.rotation().rotation_of(body).steps, 2u);  // once a step, not twice
}

TEST(RotationWorldLifetime, EndsWithBodiesInIt) {
  btSphereShape shape(1);
  btRigidBody body(1, nullptr, &shape, kInertia);
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  {
    // The world creates its own solver.
    RotationWorld<btDiscreteDynamicsWorld> world(&dispatcher, &broadphase, nullptr, &configuration);
    world.addRigidBody(&body);
    world.stepSimulation(kDt, 0);
    EXPECT_EQ(world.rotation().rotation_of(body).steps, 1u);
  }
  EXPECT_EQ(body.getBroadphaseHandle(), nullptr);
}

}  // namespace
}  // namespace polhode::testing
