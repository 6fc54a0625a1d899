// The library leaves bodies alone that Bullet does not move: asleep, switched off, static or kinematic. A
// body that moves again starts from where it stopped, without its former momentum.
#include <gtest/gtest.h>

#include "support/both_ways.h"
#include "support/motion.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 64);
const btQuaternion kTilted(btVector3(1, 2, 3).normalized(), btScalar(0.7));

// A scene with one body and one scheme.
template <class Way>
struct Stage {
  Stage(const SchemePointer& scheme, const btVector3& omega_W)
      : body(scene.add_free(btVector3(1, 2, 3), omega_W, kTilted)) {
    scene.rotation().set_scheme(body, scheme);
  }

  // Bullet waits for two seconds.
  void let_it_fall_asleep() {
    body.forceActivationState(ACTIVE_TAG);
    for (int i = 0; i < 200 && body.getActivationState() != ISLAND_SLEEPING; ++i) scene.step(kDt);
    ASSERT_EQ(body.getActivationState(), ISLAND_SLEEPING);
    ASSERT_GT(scene.rotation().rotation_of(body).steps, 100u);
  }

  RotationState state() { return scene.rotation().rotation_of(body).state; }

  Way scene;
  btRigidBody& body;
};

// Below Bullet's sleeping threshold of 1 rad/s.
const btVector3 kDrowsy = vector(0.3, 0.5, -0.4);

template <class Way>
class InactiveBody : public ::testing::Test {};
TYPED_TEST_SUITE(InactiveBody, BothWays, WayName);

TYPED_TEST(InactiveBody, StaysAsItIsWhileAsleep) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    Stage<TypeParam> stage(scheme, kDrowsy);
    stage.let_it_fall_asleep();
    stage.scene.step(kDt);
    const btMatrix3x3 basis = stage.body.getWorldTransform().getBasis();
    const std::uint64_t steps = stage.scene.rotation().rotation_of(stage.body).steps;
    stage.scene.step(kDt, 100);
    EXPECT_TRUE(same(stage.body.getWorldTransform().getBasis(), basis));
    EXPECT_TRUE(same(stage.body.getAngularVelocity(), btVector3(0, 0, 0)));
    EXPECT_EQ(stage.scene.rotation().rotation_of(stage.body).steps, steps);
    EXPECT_EQ(stage.state().L_W, Vector3::Zero());
  }
}

// Checks the number of steps too: Bullet's own update of a body at rest may change no digit.
TYPED_TEST(InactiveBody, TakesNoStepsIfAsleepFromTheStart) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    TypeParam scene;
    btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0));
    scene.rotation().set_scheme(body, scheme);
    body.forceActivationState(ISLAND_SLEEPING);
    scene.step(kDt, 10);
    EXPECT_EQ(scene.rotation().rotation_of(body).steps, 0u);
  }
}

TYPED_TEST(InactiveBody, StartsFromRestWhereItStoppedWhenItWakes) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    Stage<TypeParam> stage(scheme, kDrowsy);
    stage.let_it_fall_asleep();
    const Matrix3 basis = basis_of(stage.body);
    stage.body.forceActivationState(DISABLE_DEACTIVATION);
    stage.scene.step(kDt, 100);
    // measured 0 in single, 1.1e-16 in double precision, from normalising the quaternion again
    EXPECT_LE(distance(basis_of(stage.body), basis), by_precision(0.0, 4e-16));
    EXPECT_TRUE(same(stage.body.getAngularVelocity(), btVector3(0, 0, 0)));
  }
}

// A body woken by a torque moves like one that has always been at rest there.
TYPED_TEST(InactiveBody, WokenByATorqueMovesLikeABodyAtRestThere) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    // A body that has always been at rest is not swollen.
    if (scheme->description().rotation == Conservation::lost) continue;
    SCOPED_TRACE(scheme->description().name);
    Stage<TypeParam> woken(scheme, kDrowsy);
    woken.let_it_fall_asleep();
    const Matrix3 asleep = basis_of(woken.body);
    Stage<TypeParam> rested(scheme, btVector3(0, 0, 0));
    rested.body.setCenterOfMassTransform(woken.body.getWorldTransform());
    woken.body.activate(true);
    double worst = 0;
    for (int i = 0; i < 30; ++i) {
      for (Stage<TypeParam>* stage : {&woken, &rested}) {
        stage->body.applyTorque(btVector3(30, -20, 10));
        stage->scene.step(kDt);
      }
      worst = std::max(worst, distance(woken.state().R_WB, rested.state().R_WB));
    }
    // measured 1.1e-7 in single, 1.2e-15 in double precision
    EXPECT_LT(worst, by_precision(5e-7, 5e-15));
    EXPECT_GT(angle_between(asleep, basis_of(woken.body)), 0.5);
  }
}

TYPED_TEST(InactiveBody, StaysAsItIsWhileSwitchedOff) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    Stage<TypeParam> stage(scheme, btVector3(3, 2, 4));
    btRigidBody& body = stage.body;
    stage.scene.step(kDt, 10);
    body.forceActivationState(DISABLE_SIMULATION);
    const btMatrix3x3 basis = body.getWorldTransform().getBasis();
    const btVector3 omega_W = body.getAngularVelocity();
    stage.scene.step(kDt, 10);
    EXPECT_TRUE(same(body.getWorldTransform().getBasis(), basis));
    EXPECT_TRUE(same(body.getAngularVelocity(), omega_W));
  }
}

// Bullet switches the body off in collision detection, after a RotationWorld has begun the step, and still
// solves its joint.
template <class Way>
btVector3 velocity_after_being_switched_off(Way& scene, btRigidBody& body) {
  scene.template join<btHingeConstraint>(body, btVector3(1, 0, 0), btVector3(0, 1, 1).normalized());
  body.forceActivationState(ACTIVE_TAG);
  body.setLinearVelocity(btVector3(0, btScalar(1e9), 0));
  scene.step(kDt);
  EXPECT_EQ(body.getActivationState(), DISABLE_SIMULATION);
  return body.getAngularVelocity();
}

TYPED_TEST(InactiveBody, SwitchedOffByBulletInTheStepIsLeftToBullet) {
  Scene<> plain;
  btRigidBody& of_bullet = plain.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4), kTilted);
  const btVector3 expected_W = velocity_after_being_switched_off(plain, of_bullet);
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    Stage<TypeParam> stage(scheme, btVector3(3, 2, 4));
    EXPECT_TRUE(same(velocity_after_being_switched_off(stage.scene, stage.body), expected_W));
    EXPECT_EQ(stage.scene.rotation().rotation_of(stage.body).steps, 0u);
  }
}

TYPED_TEST(InactiveBody, StaticOrKinematicIsLeftToTheApplication) {
  TypeParam scene;
  btRigidBody& fixed = scene.add_floor();
  const btTransform pose(btQuaternion(btVector3(0, 1, 0), btScalar(0.3)), btVector3(0, 0, 20));
  btRigidBody& kinematic = scene.add_kinematic(pose, 1, btVector3(1, 2, 3));
  btRigidBody& massless =
      scene.add_kinematic(btTransform(pose.getBasis(), btVector3(0, 0, 40)), 0, btVector3(0, 0, 0));
  scene.step(kDt, 3);
  for (const btRigidBody* body : {&fixed, &kinematic, &massless})
    EXPECT_FALSE(scene.rotation().manages(*body));
  EXPECT_TRUE(same(kinematic.getWorldTransform().getBasis(), pose.getBasis()));
  EXPECT_TRUE(same(massless.getWorldTransform().getBasis(), pose.getBasis()));
  EXPECT_TRUE(same(fixed.getWorldTransform().getBasis(), btMatrix3x3::getIdentity()));
}

// The application moves the body, then releases it with the velocity that Bullet derived from its path.
TYPED_TEST(InactiveBody, ReleasedAfterBeingKinematicContinuesItsMotion) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    Stage<TypeParam> stage(scheme, btVector3(3, 2, 4));
    btRigidBody& body = stage.body;
    stage.scene.step(kDt, 10);
    body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    const double led_speed = 2;
    for (int i = 1; i <= 10; ++i) {
      btTransform pose = body.getWorldTransform();
      pose.setRotation(btQuaternion(btVector3(0, 0, 1), static_cast<btScalar>(led_speed * kDt * i)));
      body.setWorldTransform(pose);
      stage.scene.step(kDt);
      EXPECT_TRUE(same(body.getWorldTransform().getBasis(), pose.getBasis())) << i;
    }
    body.setCollisionFlags(body.getCollisionFlags() & ~btCollisionObject::CF_KINEMATIC_OBJECT);
    const Matrix3 let_go_at = basis_of(body);
    const Vector3 omega_W = omega_of(body);
    // measured 2.1e-5 in single, 2.7e-13 in double precision
    EXPECT_LT((omega_W - Vector3(0, 0, led_speed)).norm(), by_precision(1e-4, 1e-12));
    stage.scene.step(kDt);
    const Vector3 turn = turn_between(let_go_at, basis_of(body));
    // measured 1.02e-5, from the schemes' laws: 2 atan(omega dt/2), and atan(omega dt) for `matrix`
    EXPECT_LT((turn - Vector3(0, 0, led_speed * kDt)).norm(), 3e-5);
    EXPECT_TRUE(shows(body, stage.state()));
  }
}

}  // namespace
}  // namespace polhode::testing
