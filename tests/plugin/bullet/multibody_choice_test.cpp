// Selects schemes for multibodies: chosen, released, removed, refused; and checks what the library reports
// about them.
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftMultiBodyDynamicsWorld.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "support/both_ways.h"
#include "support/counted_heap.h"
#include "support/multibody_scene.h"

namespace polhode::testing {
namespace {

using ::testing::HasSubstr;

const btScalar kDt = btScalar(1.0 / 60.0);
const btVector3 kInertia(1, 2, 3);
const btVector3 kOmega(1, 8, btScalar(0.5));
const btScalar kNaN = std::numeric_limits<btScalar>::quiet_NaN();

template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

template <class Way>
class MultibodyChoice : public ::testing::Test {
 protected:
  RotationControl& rotation() { return scene_.rotation(); }
  std::string scheme_of(const btMultiBody& multibody) {
    return rotation().manages(multibody) ? std::string(rotation().rotation_of(multibody).scheme) : "Bullet";
  }

  Way scene_;
};
TYPED_TEST_SUITE(MultibodyChoice, BothWaysOfMultibodies, WayName);

TYPED_TEST(MultibodyChoice, IsTheDefaultUntilToldOtherwise) {
  btMultiBody& one = this->scene_.add_free_multibody(kInertia, kOmega);
  btMultiBody& other = this->scene_.add_multibody_box(btVector3(1, 1, 1), 1, btTransform::getIdentity());
  const btRigidBody& body = this->scene_.add_free(kInertia, kOmega);
  EXPECT_EQ(this->rotation().managed_bodies(), 3U);
  this->rotation().set_scheme(one, "quaternion");
  this->rotation().set_scheme(*other.getBaseCollider(), "rk4");
  this->scene_.step(kDt, 3);
  EXPECT_EQ(this->scheme_of(one), "quaternion");
  EXPECT_EQ(this->scheme_of(other), "rk4");
  this->rotation().use_default_scheme(one);
  this->rotation().set_default_scheme("bullet");
  EXPECT_EQ(this->scheme_of(one), "bullet");
  EXPECT_EQ(this->scheme_of(other), "rk4");
  EXPECT_EQ(this->rotation().rotation_of(body).scheme, "bullet");
  this->rotation().clear_default_scheme();
  this->scene_.step(kDt);
  EXPECT_EQ(this->scheme_of(one), "Bullet");
  EXPECT_EQ(this->rotation().managed_bodies(), 1U);
}

TYPED_TEST(MultibodyChoice, IsToldInTheSettings) {
  btMultiBody& one = this->scene_.add_free_multibody(kInertia, kOmega);
  btMultiBody& other = this->scene_.add_multibody_box(btVector3(1, 1, 1), 1, btTransform::getIdentity());
  RotationControl& rotation = this->rotation();
  EXPECT_EQ(rotation.settings_of(one).scheme, default_scheme());
  EXPECT_THAT(rotation.managed_multibodies(), ::testing::ElementsAre(&one, &other));
  rotation.set_scheme(other, "rk4");
  rotation.set_rotor_momentum(other, {0.0, 0.5, 0.0}, RotorChange::by_motor);
  for (const BodySettings& settings :
       {rotation.settings_of(other), rotation.settings_of(*other.getBaseCollider())}) {
    EXPECT_EQ(settings.scheme, find_scheme("rk4"));
    EXPECT_TRUE(settings.has_own_choice);
    EXPECT_EQ(settings.rotor_momentum_B, Vector3(0.0, 0.5, 0.0));
  }
  rotation.release(one);
  EXPECT_EQ(rotation.settings_of(one).scheme, nullptr);
  EXPECT_THAT(rotation.managed_multibodies(), ::testing::ElementsAre(&other));
  btMultiBody not_in_the_world(0, 1, btVector3(1, 1, 1), false, false);
  not_in_the_world.finalizeMultiDof();
  EXPECT_EQ(rotation.settings_of(not_in_the_world).scheme, default_scheme());
}

TYPED_TEST(MultibodyChoice, LastsWhileItIsTakenOutBetweenTwoSteps) {
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kOmega);
  this->rotation().set_scheme(multibody, "quaternion");
  this->scene_.world().removeMultiBody(&multibody);
  EXPECT_FALSE(this->rotation().manages(multibody));
  this->scene_.world().addMultiBody(&multibody);
  this->scene_.step(kDt);
  EXPECT_EQ(this->scheme_of(multibody), "quaternion");
  this->scene_.world().removeMultiBody(&multibody);
  this->scene_.step(kDt);
  this->scene_.world().addMultiBody(&multibody);
  EXPECT_EQ(this->scheme_of(multibody), "exact");
}

TYPED_TEST(MultibodyChoice, ReleasedGivesBulletsBits) {
  MultibodyScene<> plain;
  btMultiBody& expected = plain.add_free_multibody(kInertia, kOmega);
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kOmega);
  btMultiBody& managed = this->scene_.add_free_multibody(kInertia, kOmega);
  this->rotation().release(multibody);
  plain.step(kDt, 50);
  this->scene_.step(kDt, 50);
  EXPECT_EQ(multibody.getBaseOmega(), expected.getBaseOmega());
  EXPECT_EQ(multibody.getWorldToBaseRot(), expected.getWorldToBaseRot());
  EXPECT_FALSE(this->rotation().manages(multibody));
  EXPECT_TRUE(this->rotation().manages(managed));
}

TYPED_TEST(MultibodyChoice, DoesNotAccessADeletedMultibody) {
  btMultiBody& first = this->scene_.add_free_multibody(kInertia, kOmega);
  btMultiBody& second = this->scene_.add_free_multibody(kInertia, kOmega);
  this->scene_.step(kDt, 3);
  this->scene_.remove_multibody(first);
  this->scene_.step(kDt, 3);
  EXPECT_EQ(this->rotation().managed_bodies(), 1U);
  EXPECT_EQ(this->rotation().rotation_of(second).steps, 6U);
}

TYPED_TEST(MultibodyChoice, CountsAMultibodyAddedTwiceOnce) {
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kOmega);
  this->scene_.world().addMultiBody(&multibody);
  this->scene_.step(kDt, 2);
  EXPECT_EQ(this->rotation().managed_bodies(), 1U);
  this->scene_.world().removeMultiBody(&multibody);
}

TYPED_TEST(MultibodyChoice, IsNotForLinksThatMoveOrAFixedBase) {
  btMultiBody chain(1, 1, kInertia, false, false);
  chain.setupRevolute(0, 1, kInertia, -1, btQuaternion::getIdentity(), btVector3(0, 0, 1), btVector3(0, 1, 0),
                      btVector3(0, 1, 0));
  chain.finalizeMultiDof();
  btMultiBody fixed(0, 1, kInertia, true, false);
  fixed.finalizeMultiDof();
  btMultiBody unfinished(0, 1, kInertia, false, false);
  btMultiBodyLinkCollider link(&chain, 0);
  for (btMultiBody* multibody : {&chain, &fixed}) this->scene_.world().addMultiBody(multibody);
  this->scene_.step(kDt, 2);
  EXPECT_EQ(this->rotation().managed_bodies(), 0U);
  EXPECT_FALSE(this->rotation().manages(chain));
  EXPECT_THAT(error_of([&] { this->rotation().set_scheme(chain, "exact"); }), HasSubstr("movable links"));
  EXPECT_THAT(error_of([&] { this->rotation().set_scheme(link, "exact"); }), HasSubstr("movable links"));
  EXPECT_THAT(error_of([&] { this->rotation().set_scheme(fixed, "exact"); }), HasSubstr("fixed"));
  EXPECT_THAT(error_of([&] { this->rotation().set_scheme(unfinished, "exact"); }),
              HasSubstr("finalizeMultiDof"));
  EXPECT_THAT(error_of([&] { this->rotation().rotation_of(chain); }), HasSubstr("not rotated"));
  for (btMultiBody* multibody : {&chain, &fixed}) this->scene_.world().removeMultiBody(multibody);
}

// With global velocities Bullet moves even fixed links by their velocities of the last step, so the library
// does not manage the multibody.
TYPED_TEST(MultibodyChoice, FollowsTheUseOfGlobalVelocities) {
  const std::vector<FixedPart> parts = {
      {btScalar(0.5), btVector3(1, 1, 1), btTransform(btQuaternion::getIdentity(), btVector3(1, 0, 0))}};
  btMultiBody& multibody =
      this->scene_.add_free_multibody(kInertia, kOmega, btQuaternion::getIdentity(), parts);
  this->scene_.step(kDt);
  EXPECT_TRUE(this->rotation().manages(multibody));
  multibody.useGlobalVelocities(true);
  EXPECT_FALSE(this->rotation().manages(multibody));
  multibody.useGlobalVelocities(false);
  EXPECT_TRUE(this->rotation().manages(multibody));
}

TYPED_TEST(MultibodyChoice, LeavesAKinematicOneToTheApplication) {
  btMultiBody& multibody = this->scene_.add_multibody_box(btVector3(1, 1, 1), 1, btTransform::getIdentity());
  multibody.setBaseOmega(kOmega);
  multibody.setBaseDynamicType(btCollisionObject::CF_KINEMATIC_OBJECT);
  EXPECT_EQ(this->rotation().managed_bodies(), 0U);
  this->scene_.step(kDt, 3);
  EXPECT_FALSE(this->rotation().manages(multibody));
  EXPECT_EQ(multibody.getWorldToBaseRot(), btQuaternion::getIdentity());
  multibody.setBaseDynamicType(btCollisionObject::CF_DYNAMIC_OBJECT);
  EXPECT_EQ(this->rotation().managed_bodies(), 1U);
  this->scene_.step(kDt, 3);
  EXPECT_EQ(this->rotation().rotation_of(multibody).steps, 3U);
}

TYPED_TEST(MultibodyChoice, SleepsAndWakesAsBulletWants) {
  btMultiBody& multibody = this->scene_.add_multibody_box(btVector3(1, 1, 1), 1, btTransform::getIdentity());
  multibody.setCanSleep(true);
  multibody.setBaseOmega(btVector3(0, 0, btScalar(1e-3)));
  this->scene_.step(kDt, 300);
  EXPECT_EQ(multibody.getBaseCollider()->getActivationState(), ISLAND_SLEEPING);
  const std::uint64_t steps = this->rotation().rotation_of(multibody).steps;
  EXPECT_GT(steps, 60U);
  EXPECT_LT(steps, 200U);
  multibody.getBaseCollider()->forceActivationState(ACTIVE_TAG);
  multibody.wakeUp();
  multibody.setBaseOmega(kOmega);
  this->scene_.step(kDt, 5);
  EXPECT_EQ(this->rotation().rotation_of(multibody).steps, steps + 5);
}

TYPED_TEST(MultibodyChoice, ReportsWhatIsNotFinite) {
  std::vector<Incident> incidents;
  this->rotation().set_incident_handler([&](const Incident& incident) { incidents.push_back(incident); });
  struct Change {
    const char* what;
    void (*make)(btMultiBody&);
  };
  const Change changes[] = {
      {"omega", [](btMultiBody& m) { m.setBaseOmega(btVector3(0, kNaN, 0)); }},
      {"velocity", [](btMultiBody& m) { m.setBaseVel(btVector3(0, kNaN, 0)); }},
      {"place", [](btMultiBody& m) { m.setBasePos(btVector3(kNaN, 0, 0)); }},
      {"orientation", [](btMultiBody& m) { m.setWorldToBaseRot(btQuaternion(kNaN, 0, 0, 1)); }},
      {"torque", [](btMultiBody& m) { m.addBaseTorque(btVector3(kNaN, 0, 0)); }},
      {"force", [](btMultiBody& m) { m.addBaseForce(btVector3(kNaN, 0, 0)); }},
  };
  for (const Change& change : changes) {
    btMultiBody& multibody =
        this->scene_.add_multibody_box(btVector3(1, 1, 1), 1, btTransform::getIdentity());
    multibody.setBaseOmega(kOmega);
    this->scene_.step(kDt, 3);
    incidents.clear();
    change.make(multibody);
    this->scene_.step(kDt, 3);
    ASSERT_EQ(incidents.size(), 1U) << change.what;
    EXPECT_EQ(incidents[0].multibody, &multibody) << change.what;
    EXPECT_EQ(incidents[0].body, nullptr) << change.what;
    EXPECT_EQ(incidents[0].kind, IncidentKind::non_finite_body) << change.what;
    for (int i = 0; i < 6; ++i) EXPECT_TRUE(std::isfinite(multibody.getVelocityVector()[i])) << change.what;
    EXPECT_TRUE(std::isfinite(multibody.getBasePos().length2())) << change.what;
    EXPECT_NEAR(multibody.getWorldToBaseRot().length2(), btScalar(1), btScalar(1e-5)) << change.what;
    EXPECT_NEAR(multibody.getBaseOmega().length(), kOmega.length(), btScalar(1)) << change.what;
    EXPECT_TRUE(multibody.getBaseCollider()->isActive()) << change.what;
    this->scene_.remove_multibody(multibody);
    this->scene_.step(kDt);  // detects the removal: the next multibody may get the same address
  }
}

// An action that checks the application's settings in each substep: forces persist over all substeps of a
// call of stepSimulation.
class SwitchWatcher final : public btActionInterface {
 public:
  explicit SwitchWatcher(btMultiBody& multibody) : multibody_(multibody) {
    multibody.setAngularDamping(btScalar(0.1));
    multibody.setMaxCoordinateVelocity(7);
    multibody.addBaseTorque(btVector3(1, 2, 3));
    multibody.addBaseForce(btVector3(4, 5, 6));
  }
  void updateAction(btCollisionWorld* /*world*/, btScalar /*dt*/) override {
    EXPECT_TRUE(multibody_.getUseGyroTerm());
    EXPECT_EQ(multibody_.getAngularDamping(), btScalar(0.1));
    EXPECT_EQ(multibody_.getMaxCoordinateVelocity(), btScalar(7));
    EXPECT_EQ(multibody_.getBaseTorque(), btVector3(1, 2, 3));
    EXPECT_EQ(multibody_.getBaseForce(), btVector3(4, 5, 6));
    ++substeps_;
  }
  void debugDraw(btIDebugDraw* /*drawer*/) override {}
  int substeps() const { return substeps_; }

 private:
  btMultiBody& multibody_;
  int substeps_ = 0;
};

// The library overrides the switches in each step. It also overrides torque and force for fixed links, and
// for schemes that pass their gyroscopic change to a joint's solver as a torque.
TYPED_TEST(MultibodyChoice, HasItsSwitchesAndForcesBackAfterAStep) {
  const std::vector<FixedPart> parts = {
      {btScalar(0.5), btVector3(1, 1, 1), btTransform(btQuaternion::getIdentity(), btVector3(1, 0, 0))}};
  btMultiBody* const multibodies[] = {
      &this->scene_.add_free_multibody(kInertia, kOmega),
      &this->scene_.add_free_multibody(kInertia, kOmega, btQuaternion::getIdentity(), parts),
      &this->scene_.add_free_multibody(kInertia, kOmega)};
  this->rotation().set_scheme(*multibodies[2], "implicit_gyroscopic");
  this->scene_.pin(*multibodies[2], btVector3(0, 0, 0));
  btMultiBody& without_term = this->scene_.add_free_multibody(kInertia, kOmega);
  without_term.setUseGyroTerm(false);
  std::vector<std::unique_ptr<SwitchWatcher>> watchers;
  for (btMultiBody* multibody : multibodies) {
    watchers.push_back(std::make_unique<SwitchWatcher>(*multibody));
    this->scene_.world().addAction(watchers.back().get());
  }
  this->scene_.world().stepSimulation(3 * kDt, 3, kDt);
  for (const auto& watcher : watchers) {
    this->scene_.world().removeAction(watcher.get());
    EXPECT_EQ(watcher->substeps(), 3);
  }
  EXPECT_FALSE(without_term.getUseGyroTerm());
}

TYPED_TEST(MultibodyChoice, LeavesNothingBehindWhenItGoes) {
  constexpr std::size_t kMultibodies = 50;
  std::vector<btMultiBody*> multibodies;
  for (std::size_t i = 0; i < kMultibodies; ++i)
    multibodies.push_back(&this->scene_.add_free_multibody(kInertia, kOmega));
  for (btMultiBody* multibody : multibodies) this->scene_.world().removeMultiBody(multibody);
  const std::size_t blocks = heap_blocks();
  for (btMultiBody* multibody : multibodies) this->scene_.world().addMultiBody(multibody);
  this->scene_.step(kDt, 2);
  EXPECT_GE(heap_blocks(), blocks + kMultibodies);
  for (btMultiBody* multibody : multibodies) this->scene_.world().removeMultiBody(multibody);
  this->scene_.step(kDt, 2);
  EXPECT_LE(heap_blocks(), blocks + kMultibodies / 2);  // measured + 12: lists keep their capacity
}

TYPED_TEST(MultibodyChoice, ChangesTogetherWithRigidBodiesOrNotAtAll) {
  const btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kOmega);
  const btRigidBody& body = this->scene_.add_free(kInertia, kOmega);
  this->scene_.step(kDt);
  std::size_t granted = 0;
  for (bool is_done = false; !is_done; ++granted) {
    MemoryShortage shortage(granted, MemoryReturns::when_told);
    try {
      this->rotation().set_default_scheme("quaternion");
      is_done = true;
    } catch (const std::bad_alloc&) {
    }
    shortage.end();
    EXPECT_EQ(this->scheme_of(multibody), is_done ? "quaternion" : "exact") << granted;
    EXPECT_EQ(this->rotation().rotation_of(body).scheme, is_done ? "quaternion" : "exact") << granted;
  }
  EXPECT_GE(granted, 4U);  // one batch and one family for each kind
}

TYPED_TEST(MultibodyChoice, IsLeftToBulletWithoutMemory) {
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kOmega);
  {
    const MemoryShortage shortage(0, MemoryReturns::when_told);
    this->scene_.step(kDt, 3);
    EXPECT_THROW(this->rotation().set_scheme(multibody, "rk4"), std::bad_alloc);
  }
  this->scene_.step(kDt, 3);
  EXPECT_EQ(this->scheme_of(multibody), "exact");
  EXPECT_EQ(this->rotation().rotation_of(multibody).steps, 3U);
}

TYPED_TEST(MultibodyChoice, StopsWhenItsSchemeDiverges) {
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, btVector3(10, 80, 5));
  this->rotation().set_scheme(multibody, "semi_implicit_gyroscopic");
  this->scene_.step(kDt, 600);
  EXPECT_TRUE(this->rotation().rotation_of(multibody).diverged);
  EXPECT_EQ(multibody.getBaseOmega(), btVector3(0, 0, 0));
  EXPECT_TRUE(multibody.getUseGyroTerm());
  this->scene_.step(kDt);
  multibody.setBaseOmega(btVector3(0, kNaN, 0));
  multibody.addBaseForce(btVector3(0, 0, kNaN));
  this->scene_.step(kDt);
  EXPECT_TRUE(std::isfinite(multibody.getBaseOmega().length()));
  EXPECT_TRUE(std::isfinite(multibody.getBasePos().length()));
  EXPECT_TRUE(std::isfinite(multibody.getWorldToBaseRot().length()));
}

// In such a step the angle overflows a double, and Bullet's own orientation becomes non-finite.
TYPED_TEST(MultibodyChoice, StopsInAStepTooLongToTurnIt) {
  const std::vector<FixedPart> parts = {
      {btScalar(0.5), btVector3(1, 1, 1), btTransform(btQuaternion::getIdentity(), btVector3(1, 0, 0))}};
  const btVector3 slow_W(btScalar(1e-9), btScalar(2e-9), 0);
  const btMultiBody* const multibodies[] = {
      &this->scene_.add_free_multibody(kInertia, slow_W),
      &this->scene_.add_free_multibody(kInertia, slow_W, btQuaternion::getIdentity(), parts)};
  this->scene_.step(btScalar(-3e38));
  for (const btMultiBody* multibody : multibodies) {
    EXPECT_NEAR(multibody->getWorldToBaseRot().length(), 1, btScalar(1e-6));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(multibody->getBasePos()[i])) << i;
    EXPECT_EQ(multibody->getBaseOmega(), btVector3(0, 0, 0));
    EXPECT_TRUE(this->rotation().rotation_of(*multibody).diverged);
  }
}

TEST(MultibodyPlugin, LeavesMultibodiesAsTheyWere) {
  MultibodiesUnderRotationPlugin scene;
  MultibodyScene<> plain;
  btMultiBody& multibody = scene.add_free_multibody(kInertia, kOmega);
  btMultiBody& expected = plain.add_free_multibody(kInertia, kOmega);
  scene.plugin().detach();
  scene.step(kDt, 20);
  plain.step(kDt, 20);
  EXPECT_EQ(multibody.getBaseOmega(), expected.getBaseOmega());
  scene.plugin().attach();
  scene.step(kDt, 20);
  EXPECT_EQ(scene.rotation().rotation_of(multibody).steps, 20U);
}

template <class AScene>
std::uint64_t steps_of_multibody(AScene& scene, RotationControl& rotation) {
  btMultiBody& multibody = scene.add_free_multibody(kInertia, kOmega);
  scene.step(kDt, 5);
  return rotation.rotation_of(multibody).steps;
}

TEST(MultibodyWorlds, WithSoftBodiesAreAccepted) {
  MultibodyScene<RotationWorld<btSoftMultiBodyDynamicsWorld>> made;
  EXPECT_EQ(made.world().getWorldType(), BT_SOFT_MULTIBODY_DYNAMICS_WORLD);
  EXPECT_EQ(steps_of_multibody(made, made.world().rotation()), 5U);
  MultibodyScene<btSoftMultiBodyDynamicsWorld> found;
  RotationPlugin plugin(found.world());
  EXPECT_EQ(steps_of_multibody(found, plugin.rotation()), 5U);
}

TEST(MultibodyWorlds, WithDeformableBodiesAreRefusedWithTheReason) {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btDeformableBodySolver deformable_solver;
  btDeformableMultiBodyConstraintSolver solver;
  solver.setDeformableSolver(&deformable_solver);
  btDeformableMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration,
                                           &deformable_solver);
  EXPECT_THAT(error_of([&] { const RotationPlugin plugin(world); }), HasSubstr("deformable bodies together"));
}

}  // namespace
}  // namespace polhode::testing
