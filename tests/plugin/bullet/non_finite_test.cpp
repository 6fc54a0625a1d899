// A NaN spreads: in plain Bullet one non-finite body ruins a pile. With the library it stays contained and is
// reported and counted once.
#include "bullet/body/non_finite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/both_ways.h"
#include "support/precision.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

constexpr btScalar kNan = std::numeric_limits<btScalar>::quiet_NaN();
constexpr btScalar kInfinity = std::numeric_limits<btScalar>::infinity();
constexpr btScalar kDt = btScalar(1.0 / 60.0);

// Twenty boxes, settled into a pile.
template <class World>
void add_pile(Scene<World>& scene) {
  scene.world().setGravity(btVector3(0, 0, -10));
  scene.add_floor();
  for (int i = 0; i < 20; ++i) {
    const btVector3 origin(btScalar(i % 2) * btScalar(0.3), btScalar(i % 3) * btScalar(0.2),
                           btScalar(0.5) + btScalar(0.95) * btScalar(i));
    scene.add_box(btVector3(1, 1, 1) / 2, 1, btTransform(btQuaternion::getIdentity(), origin));
  }
}

int bodies_not_finite(const std::vector<std::unique_ptr<btRigidBody>>& bodies) {
  int count = 0;
  for (const auto& body : bodies) count += is_finite(*body) ? 0 : 1;
  return count;
}

struct Reports {
  explicit Reports(RotationControl& rotation) {
    rotation.set_incident_handler([this](const Incident& incident) { list.push_back(incident); });
  }
  std::vector<Incident> list;
};

using Spoil = void (*)(btRigidBody&);

struct Case {
  const char* name;
  Spoil spoil;
};

const Case kCases[] = {
    {"NanSpin", [](btRigidBody& body) { body.setAngularVelocity(btVector3(kNan, 0, 0)); }},
    {"InfiniteSpin", [](btRigidBody& body) { body.setAngularVelocity(btVector3(0, kInfinity, 0)); }},
    {"NanVelocity", [](btRigidBody& body) { body.setLinearVelocity(btVector3(0, kNan, 0)); }},
    {"NanTorque", [](btRigidBody& body) { body.applyTorque(btVector3(0, kNan, 0)); }},
    {"NanOrientation",
     [](btRigidBody& body) {
       body.setWorldTransform(
           btTransform(btMatrix3x3(kNan, 0, 0, 0, 1, 0, 0, 0, 1), body.getWorldTransform().getOrigin()));
     }},
    {"InfinitePosition",
     [](btRigidBody& body) { body.getWorldTransform().setOrigin(btVector3(kInfinity, 0, 0)); }},
};

class NonFiniteBody : public ::testing::TestWithParam<Case> {};

TEST_P(NonFiniteBody, SpoilsAPileOfPlainBullet) {
  Scene<> scene;
  add_pile(scene);
  scene.step(kDt, 60);
  GetParam().spoil(*scene.bodies()[10]);
  scene.step(kDt, 60);
  EXPECT_GE(bodies_not_finite(scene.bodies()), 1);
}

TEST_P(NonFiniteBody, LeavesItsNeighboursInARotationWorldAloneAndIsReportedOnce) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  Reports reports(rotation);
  add_pile(scene);
  scene.step(kDt, 60);
  btRigidBody& spoiled = *scene.bodies()[10];
  for (int i = 0; i < 60; ++i) {
    if (i < 5) GetParam().spoil(spoiled);
    scene.step(kDt);
    ASSERT_EQ(bodies_not_finite(scene.bodies()), 0) << i;
  }
  ASSERT_EQ(reports.list.size(), 1u);
  EXPECT_EQ(reports.list[0].body, &spoiled);
  EXPECT_EQ(reports.list[0].kind, IncidentKind::non_finite_body);
  EXPECT_EQ(reports.list[0].body_steps, 61u);  // reported at the end of the step
  EXPECT_EQ(rotation.incidents(), 5u);
  EXPECT_FALSE(rotation.rotation_of(spoiled).diverged);
}

TEST_P(NonFiniteBody, LeavesEveryBodyFiniteAfterEveryStepOfAnAttachedPlugin) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  Reports reports(plugin.rotation());
  add_pile(scene);
  scene.step(kDt, 60);
  GetParam().spoil(*scene.bodies()[10]);
  for (int i = 0; i < 60; ++i) {
    scene.step(kDt);
    ASSERT_EQ(bodies_not_finite(scene.bodies()), 0) << i;
  }
  EXPECT_GE(plugin.rotation().incidents(), 1u);
  EXPECT_EQ(reports.list.size(), plugin.rotation().incidents());
  // The pile still stands: no box was thrown off.
  for (const auto& body : scene.bodies()) EXPECT_LE(body->getLinearVelocity().length(), 5);
}

TEST_P(NonFiniteBody, IsReportedAloneByAnAttachedPlugin) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  Reports reports(plugin.rotation());
  add_pile(scene);
  scene.step(kDt, 60);
  GetParam().spoil(*scene.bodies()[10]);
  scene.step(kDt, 60);
  ASSERT_EQ(reports.list.size(), 1u);
  EXPECT_EQ(reports.list[0].body, scene.bodies()[10].get());
  EXPECT_EQ(bodies_not_finite(scene.bodies()), 0);
}

INSTANTIATE_TEST_SUITE_P(, NonFiniteBody, ::testing::ValuesIn(kCases),
                         [](const auto& spoiled) { return spoiled.param.name; });

// A scheme that turns the body at a constant rate and returns NaN after a few steps.
class Breaking final : public RotationScheme {
 public:
  SchemeDescription description() const noexcept override { return {"breaking", "", "", ""}; }
  void step(const StepInput& input, RotationState& state) const noexcept override {
    state.omega_W += input.delta_omega_W;
    if (state.q_WB.z() > 0.05) state.omega_W.x() = std::numeric_limits<double>::quiet_NaN();
    state.q_WB = (state.q_WB * Quaternion(0.999, 0.0, 0.0, 0.03)).normalized();
    state.R_WB = state.q_WB.toRotationMatrix();
  }
};

TEST(BrokenScheme, LeavesThePileFiniteAndTheBodyAtItsLastFiniteState) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  Reports reports(rotation);
  add_pile(scene);
  scene.step(kDt, 60);
  btRigidBody& body = *scene.bodies()[10];
  rotation.set_scheme(body, std::make_shared<Breaking>());
  const auto step = [&scene](int count) {
    for (int i = 0; i < count; ++i) {
      scene.step(kDt);
      ASSERT_EQ(bodies_not_finite(scene.bodies()), 0) << i;
    }
  };
  // In contact the body turns by the solver's velocity and the scheme is not used.
  step(60);
  EXPECT_EQ(rotation.incidents(), 0u);
  body.translate(btVector3(20, 0, 20));
  step(60);
  ASSERT_EQ(reports.list.size(), 1u);
  EXPECT_EQ(reports.list[0].kind, IncidentKind::scheme_diverged);
  EXPECT_EQ(rotation.incidents(), 1u);
  const BodyRotation last = rotation.rotation_of(body);
  EXPECT_TRUE(last.diverged);
  EXPECT_TRUE(last.state.all_finite());
  EXPECT_EQ(last.steps, reports.list[0].body_steps);
  EXPECT_EQ(last.scheme, "breaking");
}

TEST(BrokenScheme, StartsAfreshWhenAnotherIsSet) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  btRigidBody& body = scene.add_free(btVector3(btScalar(24.1449), btScalar(28.436), btScalar(118.812)),
                                     btVector3(btScalar(0.1), 10, 0));
  rotation.set_scheme(body, "semi_implicit_gyroscopic");
  scene.step(btScalar(0.03), 1000);
  ASSERT_TRUE(rotation.rotation_of(body).diverged);
  EXPECT_EQ(body.getAngularVelocity(), btVector3(0, 0, 0));
  rotation.set_scheme(body, "quaternion");
  body.setAngularVelocity(btVector3(0, 1, 0));
  scene.step(kDt, 10);
  EXPECT_FALSE(rotation.rotation_of(body).diverged);
  EXPECT_EQ(rotation.rotation_of(body).steps, 10u);
}

TEST(IncidentHandler, ThatThrowsDoesNotReachTheStep) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  scene.world().rotation().set_incident_handler([](const Incident&) { throw 1; });
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(kNan, 0, 0));
  EXPECT_NO_THROW(scene.step(kDt));
  EXPECT_EQ(scene.world().rotation().incidents(), 1u);
  EXPECT_TRUE(is_finite(body));
}

// The handler treats each of three bodies that diverge in the same step differently.
TEST(IncidentHandler, MayChooseAnotherSchemeReleaseOrRemoveTheBody) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  rotation.set_default_scheme(std::make_shared<Breaking>());
  btRigidBody& reassigned = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  btRigidBody& released = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  btRigidBody& removed = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  btRigidBody& last = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  int reports = 0;
  rotation.set_incident_handler([&](const Incident& incident) {
    ++reports;
    if (incident.body == &reassigned) rotation.set_scheme(reassigned, "quaternion");
    if (incident.body == &released) rotation.release(released);
    if (incident.body == &removed) scene.world().removeRigidBody(&removed);
  });
  scene.step(kDt, 20);
  EXPECT_EQ(reports, 4);
  EXPECT_EQ(rotation.rotation_of(reassigned).scheme, "quaternion");
  EXPECT_FALSE(rotation.manages(released));
  EXPECT_FALSE(removed.isInWorld());
  EXPECT_TRUE(rotation.rotation_of(last).diverged);
}

TEST(SanitizedBody, KeepsWhatWasFinite) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  body.setWorldTransform(btTransform(btQuaternion(1, 2, 3, 4).normalized(), btVector3(5, 6, 7)));
  body.setLinearVelocity(btVector3(1, 0, kNan));
  scene.step(kDt);
  const BodyRotation rotation = scene.world().rotation().rotation_of(body);
  EXPECT_EQ(rotation.steps, 1u);
  EXPECT_EQ(body.getWorldTransform().getOrigin(), btVector3(5, 6, 7));
  EXPECT_EQ(body.getLinearVelocity(), btVector3(0, 0, 0));
  EXPECT_GT(rotation.state.omega_W.norm(), 5.0);
}

template <class Way>
class Overflow : public ::testing::Test {};
TYPED_TEST_SUITE(Overflow, BothWays, WayName);

// The velocity is finite, but the displacement in a step is not.
TYPED_TEST(Overflow, OfThePositionLeavesTheBodyWhereItWas) {
  TypeParam scene;
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  scene.step(kDt);
  body.setLinearVelocity(btVector3(0, std::numeric_limits<btScalar>::max(), 0));
  scene.world().stepSimulation(10, 0);
  EXPECT_TRUE(is_finite(body));
  EXPECT_EQ(scene.rotation().incidents(), 1u);
}

// The application writes a basis that is not a rotation; the reported quaternion still has unit length.
TYPED_TEST(Overflow, OfTheOrientationGivesAUnitQuaternion) {
  TypeParam scene;
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(1, 2, 3));
  scene.step(kDt);
  const btScalar largest = std::numeric_limits<btScalar>::max();
  body.getWorldTransform().getBasis()[0] = btVector3(largest, -30, -2);
  EXPECT_NEAR(scene.rotation().rotation_of(body).state.q_WB.norm(), 1.0, 1e-12);
}

// Bullet rotates a diverged body, here with a gyroscopic term that is not finite.
TYPED_TEST(Overflow, OfADivergedBodyIsTakenOutInTheSameStep) {
  TypeParam scene;
  const btScalar huge = std::numeric_limits<btScalar>::max();
  btRigidBody& body = scene.add_free(btVector3(huge, 0, 0), btVector3(huge, 1, huge));
  for (int i = 0; i < 5; ++i) {
    scene.step(kDt);
    EXPECT_TRUE(is_finite(body)) << i;
  }
  EXPECT_TRUE(scene.rotation().rotation_of(body).diverged);
}

// In double precision L = I omega overflows: the body counts as at rest, and the next step stops it.
TYPED_TEST(Overflow, OfTheMomentumStopsTheBodyAsADivergedOne) {
  const btScalar huge = std::numeric_limits<btScalar>::max();
  for (const SchemePointer& scheme : built_in_schemes()) {
    for (const btVector3& omega_W : {btVector3(huge, 0, 0), btVector3(huge, huge, -huge)}) {
      for (const bool is_new : {true, false}) {
        SCOPED_TRACE(scheme->description().name);
        TypeParam scene;
        btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
        scene.rotation().set_scheme(body, scheme);
        if (!is_new) scene.step(kDt, 3);
        body.setAngularVelocity(omega_W);
        const auto expect_finite = [&] {
          const BodyRotation rotation = scene.rotation().rotation_of(body);
          EXPECT_TRUE(rotation.state.all_finite());
          EXPECT_TRUE(std::isfinite(rotation.energy_J));
          EXPECT_TRUE(is_finite(body));
        };
        expect_finite();
        scene.step(kDt);
        expect_finite();
        EXPECT_TRUE(scene.rotation().rotation_of(body).diverged);
        EXPECT_EQ(body.getAngularVelocity(), btVector3(0, 0, 0));
        EXPECT_EQ(scene.rotation().incidents(), 1u);
      }
    }
  }
}

// A body with a moment near the largest double also stops, even at a moderate velocity.
TYPED_TEST(Overflow, OfTheEnergyStopsTheBodyAsADivergedOne) {
  if (!kDoubleBullet) GTEST_SKIP() << "moments of single precision are far from the largest double";
  const auto huge = static_cast<btScalar>(1e300);
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    TypeParam scene;
    btRigidBody& body = scene.add_free(btVector3(huge, huge, huge), btVector3(0, 0, 0));
    scene.rotation().set_scheme(body, scheme);
    body.setAngularVelocity(btVector3(0, 0, 100000));
    EXPECT_TRUE(std::isfinite(scene.rotation().rotation_of(body).energy_J));
    scene.step(kDt);
    EXPECT_TRUE(scene.rotation().rotation_of(body).diverged);
    EXPECT_TRUE(std::isfinite(scene.rotation().rotation_of(body).energy_J));
  }
}

// Bullet wakes a body of an awake island right before solving, after the library has begun the step without
// the body: only Bullet's integration moves the body.
TYPED_TEST(Overflow, OfABodyThatBulletWakesInTheStepIsTakenOutInTheSameStep) {
  TypeParam scene;
  btRigidBody& awake = scene.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0));
  btRigidBody& asleep = scene.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0));
  // The bounding boxes overlap, which joins the two in one island, but the spheres do not touch.
  btCollisionShape& ball = scene.template shape<btSphereShape>(1);
  for (btRigidBody* body : {&awake, &asleep}) body->setCollisionShape(&ball);
  asleep.setCenterOfMassTransform(
      btTransform(btQuaternion::getIdentity(),
                  awake.getWorldTransform().getOrigin() + btVector3(1, 1, 1) * btScalar(1.5)));
  scene.step(kDt, 2);
  asleep.forceActivationState(ISLAND_SLEEPING);
  asleep.applyCentralForce(btVector3(0, std::numeric_limits<btScalar>::max(), 0));
  scene.world().stepSimulation(10, 0);
  EXPECT_NE(asleep.getActivationState(), ISLAND_SLEEPING);
  EXPECT_TRUE(is_finite(asleep));
  EXPECT_TRUE(is_finite(awake));
  EXPECT_EQ(scene.rotation().incidents(), 1u);
}

// The solver also affects bodies that Bullet or the application has switched off, although these take no
// step.
TYPED_TEST(Overflow, OfABodyThatIsSwitchedOffIsTakenOutInTheSameStep) {
  TypeParam scene;
  const btScalar huge = std::numeric_limits<btScalar>::max();
  btRigidBody& on = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  btRigidBody& off = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  scene.template join<btPoint2PointConstraint>(on, off, btVector3(5, 0, 0), btVector3(-5, 0, 0));
  scene.step(kDt, 2);
  off.forceActivationState(DISABLE_SIMULATION);
  on.setLinearVelocity(btVector3(huge, huge, huge));
  for (int i = 0; i < 3; ++i) {
    scene.step(kDt);
    EXPECT_TRUE(is_finite(on)) << i;
    EXPECT_TRUE(is_finite(off)) << i;
  }
  EXPECT_GE(scene.rotation().incidents(), 1u);
}

// The same if Bullet switches the body off within the step, also when Bullet integrates the bodies itself.
TYPED_TEST(Overflow, OfABodyThatBulletSwitchesOffIsTakenOutInTheSameStep) {
  for (const bool by_bullet : {false, true}) {
    TypeParam scene;
    scene.world().setApplySpeculativeContactRestitution(by_bullet);
    const btScalar huge = std::numeric_limits<btScalar>::max();
    btRigidBody& on = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    btRigidBody& off = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
    scene.template join<btPoint2PointConstraint>(on, off, btVector3(5, 0, 0), btVector3(-5, 0, 0));
    off.forceActivationState(ACTIVE_TAG);
    off.setLinearVelocity(btVector3(-huge, -huge, -huge));
    on.setLinearVelocity(btVector3(huge, huge, huge));
    scene.step(kDt);
    EXPECT_EQ(off.getActivationState(), ACTIVE_TAG) << by_bullet;  // as set when the body was reset
    EXPECT_TRUE(is_finite(on)) << by_bullet;
    EXPECT_TRUE(is_finite(off)) << by_bullet;
    EXPECT_EQ(scene.rotation().incidents(), 2u) << by_bullet;
  }
}

// The solver gets the state to which the body is reset, which is finite however long the step is.
TYPED_TEST(Overflow, OfALockedBodysFreeTurnIsNotGivenToTheSolver) {
  const btScalar huge = std::numeric_limits<btScalar>::max();
  for (const SchemePointer& scheme : built_in_schemes()) {
    for (const btVector3& factor : {btVector3(1, 0, 0), btVector3(1, 1, 0)}) {
      SCOPED_TRACE(scheme->description().name);
      TypeParam scene;
      btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0));
      scene.rotation().set_scheme(body, scheme);
      body.setAngularFactor(factor);
      body.setAngularVelocity(btVector3(20, 15, 19));
      scene.world().stepSimulation(huge, 1, huge);
      EXPECT_TRUE(is_finite(body));
      EXPECT_TRUE(scene.rotation().rotation_of(body).state.all_finite());
    }
  }
}

// A step in which a body diverges is not counted, even if it was passed to the solver as unresolved.
TYPED_TEST(Overflow, InAnUnresolvedStepCountsAsNoStep) {
  TypeParam scene;
  btRigidBody& body = scene.add_free(btVector3(1, 10, 10), btVector3(0, 0, 0));
  scene.template join<btPoint2PointConstraint>(body, btVector3(0, 0, 0));
  body.setAngularVelocity(btVector3(1, 2, 2) * btScalar(1e9));
  scene.step(kDt);
  const BodyRotation rotation = scene.rotation().rotation_of(body);
  EXPECT_TRUE(rotation.diverged);
  EXPECT_EQ(rotation.steps, 0u);
  EXPECT_EQ(rotation.unresolved_steps, 0u);
}

TEST(StepOfNanSeconds, LeavesEveryBodyFinite) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  scene.step(kDt);
  scene.world().stepSimulation(kNan, 0, kNan);
  EXPECT_TRUE(is_finite(body));
}

}  // namespace
}  // namespace polhode::testing
