// Selects the scheme of a body: the world's default, its own, one written by the application, or none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <set>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "polhode/bullet/conversions.h"
#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "polhode/rotation_math.h"
#include "polhode/torque_laws.h"
#include "support/precision.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60.0);
const btVector3 kInertia(1, 2, 3);
const btVector3 kSpin(3, 2, 4);

// A custom scheme: the exponential map at constant angular momentum.
class ConstantMomentum final : public RotationScheme {
 public:
  SchemeDescription description() const noexcept override {
    return {"constant_momentum", "the exponential map at constant L", "this test", "never here"};
  }
  void step(const StepInput& input, RotationState& state) const noexcept override {
    const Vector3 L_W = state.L_W + angular_momentum_W(state.R_WB, input.inertia_B, input.delta_omega_W);
    const Vector3 omega_W = inverse_inertia_W(state.R_WB, input.inertia_B) * L_W;
    set_orientation(state, (exponential(omega_W * input.dt) * state.q_WB).normalized());
    set_angular_momentum(state, input.inertia_B, L_W);
  }
};

TEST(SchemeChoice, DefaultIsTheLibrarysForEveryDynamicBodyNowAndLater) {
  Scene<> scene;
  btRigidBody& before = scene.add_free(kInertia, kSpin);
  RotationPlugin plugin(scene.world());
  btRigidBody& after = scene.add_free(kInertia, kSpin);
  scene.step(kDt);
  for (const btRigidBody* body : {&before, &after}) {
    EXPECT_EQ(plugin.rotation().rotation_of(*body).scheme, default_scheme()->description().name);
  }
  plugin.rotation().set_default_scheme("quaternion");
  EXPECT_EQ(plugin.rotation().rotation_of(before).scheme, "quaternion");
  plugin.rotation().clear_default_scheme();
  EXPECT_EQ(plugin.rotation().managed_bodies(), 0u);
}

TEST(SchemeChoice, OfABodyStandsAgainstTheDefault) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  btRigidBody& chosen = scene.add_free(kInertia, kSpin);
  btRigidBody& released = scene.add_free(kInertia, kSpin);
  btRigidBody& other = scene.add_free(kInertia, kSpin);
  rotation.set_scheme(chosen, "matrix");
  rotation.release(released);
  rotation.set_default_scheme("quaternion");
  scene.step(kDt, 3);
  EXPECT_EQ(rotation.rotation_of(chosen).scheme, "matrix");
  EXPECT_FALSE(rotation.manages(released));
  EXPECT_EQ(rotation.rotation_of(other).scheme, "quaternion");
  rotation.use_default_scheme(chosen);
  rotation.use_default_scheme(released);
  EXPECT_EQ(rotation.rotation_of(chosen).scheme, "quaternion");
  EXPECT_EQ(rotation.rotation_of(released).scheme, "quaternion");
}

TEST(SchemeChoice, MayBeOneThatTheApplicationWrote) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  btRigidBody& body = scene.add_free(kInertia, kSpin);
  rotation.set_scheme(body, std::make_shared<ConstantMomentum>());
  const Vector3 L_W = rotation.rotation_of(body).state.L_W;
  scene.step(kDt, 600);
  const BodyRotation later = rotation.rotation_of(body);
  EXPECT_EQ(later.scheme, "constant_momentum");
  EXPECT_EQ(later.steps, 600u);
  // measured 0
  EXPECT_LE((later.state.L_W - L_W).norm(), 1e-14 * L_W.norm());
}

TEST(SchemeChoice, KeepsTheApplicationsSchemeAliveAsLongAsABodyHasIt) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  btRigidBody& body = scene.add_free(kInertia, kSpin);
  std::weak_ptr<const RotationScheme> watched;
  {
    const auto scheme = std::make_shared<const ConstantMomentum>();
    watched = scheme;
    scene.world().rotation().set_scheme(body, scheme);
  }
  scene.step(kDt);
  EXPECT_FALSE(watched.expired());
  scene.world().rotation().use_default_scheme(body);
  EXPECT_TRUE(watched.expired());
}

TEST(SchemeChoice, MayBeByTheNameOfARegisteredOne) {
  register_scheme(std::make_shared<ConstantMomentum>());
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  btRigidBody& body = scene.add_free(kInertia, kSpin);
  scene.world().rotation().set_scheme(body, "constant_momentum");
  scene.step(kDt);
  EXPECT_EQ(scene.world().rotation().rotation_of(body).scheme, "constant_momentum");
}

TEST(SettingsOf, TellEverythingThatWasSet) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  btRigidBody& body = scene.add_free(kInertia, kSpin);
  EXPECT_EQ(rotation.default_scheme(), default_scheme());
  BodySettings settings = rotation.settings_of(body);
  EXPECT_EQ(settings.scheme, default_scheme());
  EXPECT_FALSE(settings.has_own_choice || settings.torque_law);

  rotation.set_scheme(body, "rk4");
  rotation.set_torque_law(body, rate_damping(0.25), TorqueLawOrder::four);
  rotation.set_rotor_momentum(body, {0.0, 0.5, 0.0}, RotorChange::from_outside);
  rotation.set_rotor_torque(body, {0.0, 0.0, 0.125});
  settings = rotation.settings_of(body);
  EXPECT_EQ(settings.scheme, find_scheme("rk4"));
  EXPECT_TRUE(settings.has_own_choice);
  TorqueLawInput motion{};
  motion.q_WB = Quaternion::Identity();
  motion.omega_W = {1.0, 0.0, 0.0};
  EXPECT_EQ(settings.torque_law(motion), Torque(BodyTorque{Vector3(-0.25, 0.0, 0.0)}));
  EXPECT_EQ(settings.torque_law_order, TorqueLawOrder::four);
  EXPECT_EQ(settings.rotor_momentum_B, Vector3(0.0, 0.5, 0.0));
  EXPECT_EQ(settings.rotor_torque_B, Vector3(0.0, 0.0, 0.125));
  scene.step(kDt);
  EXPECT_NE(rotation.settings_of(body).rotor_momentum_B, settings.rotor_momentum_B);  // the motors have run
  EXPECT_EQ(rotation.settings_of(body).rotor_momentum_B, rotation.rotation_of(body).state.rotor_momentum_B);

  rotation.release(body);
  settings = rotation.settings_of(body);
  EXPECT_EQ(settings.scheme, nullptr);
  EXPECT_TRUE(settings.has_own_choice);
  EXPECT_FALSE(settings.torque_law);
  rotation.use_default_scheme(body);
  rotation.clear_default_scheme();
  EXPECT_EQ(rotation.default_scheme(), nullptr);
  EXPECT_EQ(rotation.settings_of(body).scheme, nullptr);
  EXPECT_FALSE(rotation.settings_of(body).has_own_choice);
}

TEST(SettingsOf, AreRefusedForWhatCannotBeRotated) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  const btCollisionObject object;
  EXPECT_THROW(scene.world().rotation().settings_of(object), std::invalid_argument);
}

TEST(ManagedBodies, AreListedInTheOrderOfTheWorld) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  EXPECT_TRUE(rotation.managed_rigid_bodies().empty() && rotation.managed_multibodies().empty());
  std::vector<btRigidBody*> bodies;
  for (int i = 0; i < 20; ++i) bodies.push_back(&scene.add_free(kInertia, kSpin));
  rotation.set_scheme(*bodies[3], "matrix");
  EXPECT_EQ(rotation.managed_rigid_bodies(), bodies);
  rotation.release(*bodies[0]);
  bodies[5]->setCollisionFlags(bodies[5]->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  scene.world().removeRigidBody(bodies[7]);
  for (const std::size_t index : {7U, 5U, 0U}) bodies.erase(bodies.begin() + index);
  // Bullet fills the gap with its last body.
  std::swap(bodies[5], bodies.back());
  std::vector<btRigidBody*> expected;
  for (int i = 0; i < scene.world().getNumCollisionObjects(); ++i) {
    btRigidBody* const body = btRigidBody::upcast(scene.world().getCollisionObjectArray()[i]);
    if (rotation.manages(*body)) expected.push_back(body);
  }
  EXPECT_EQ(expected.size(), 17U);
  EXPECT_THAT(rotation.managed_rigid_bodies(), ::testing::UnorderedElementsAreArray(expected));
  EXPECT_EQ(rotation.managed_bodies(), 17U);
}

// A body that gets the address of a deleted one does not inherit the settings of the deleted one.
TEST(ManagedBodies, HaveOneThatReplacedAReleasedOneAtItsAddress) {
  Scene<RotationWorld<btDiscreteDynamicsWorld>> scene;
  RotationControl& rotation = scene.world().rotation();
  btRigidBody& body = scene.add_free(kInertia, kSpin);
  rotation.release(body);
  scene.step(kDt);
  EXPECT_TRUE(rotation.managed_rigid_bodies().empty());
  scene.world().removeRigidBody(&body);
  const btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, body.getCollisionShape(), kInertia);
  body.~btRigidBody();
  new (&body) btRigidBody(info);
  scene.world().addRigidBody(&body);
  EXPECT_TRUE(rotation.manages(body));
  EXPECT_THAT(rotation.managed_rigid_bodies(), ::testing::ElementsAre(&body));
}

TEST(Names, OfEnumeratorsAreTheirOwn) {
  const std::set<std::string_view> kinds = {to_string(IncidentKind::scheme_diverged),
                                            to_string(IncidentKind::non_finite_body),
                                            to_string(IncidentKind::torque_law_failed)};
  EXPECT_EQ(kinds.size(), 3U);
  EXPECT_EQ(to_string(RotorChange::by_motor), "by motor");
  EXPECT_EQ(to_string(RotorChange::from_outside), "from outside");
  EXPECT_EQ(to_string(TorqueLawOrder::two), "two");
  EXPECT_EQ(to_string(TorqueLawOrder::four), "four");
  EXPECT_EQ(to_string(TurnVelocity::start), "start");
  EXPECT_EQ(to_string(TurnVelocity::end), "end");
  EXPECT_EQ(to_string(TurnVelocity::mean), "mean");
}

TEST(Conversions, GoToEigenAndBack) {
  const btTransform pose(btQuaternion(btVector3(1, 2, 3).normalized(), btScalar(0.7)), btVector3(4, 5, 6));
  const Quaternion q = to_double(pose.getRotation());
  EXPECT_TRUE(to_bullet(q) == pose.getRotation());
  // It rotates a vector as Bullet's quaternion does. Measured 5e-7 in single precision, 1e-15 in double.
  const Vector3 turned = q * Vector3(1, -2, 4);
  EXPECT_LT((turned - to_double(quatRotate(pose.getRotation(), btVector3(1, -2, 4)))).norm(),
            by_precision(2e-6, 4e-15));
  EXPECT_TRUE(to_bullet(to_double(pose)) == pose);
  EXPECT_EQ(to_double(pose) * Vector3::Zero(), Vector3(4, 5, 6));
}

TEST(RotationOf, TellsTheApplicationsVelocityBeforeAnyStep) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  btRigidBody& body = scene.add_free(kInertia, kSpin);
  body.setAngularVelocity(btVector3(0, 0, 2));
  const BodyRotation rotation = plugin.rotation().rotation_of(body);
  EXPECT_EQ(rotation.state.omega_W, Vector3(0, 0, 2));
  // 3 kg m^2 about z; Bullet rounds 1/3: measured 1.8e-7 in single precision, 0 in double
  EXPECT_NEAR(rotation.state.L_W.z(), 6.0, by_precision(1e-6, 2e-15));
  EXPECT_NEAR(rotation.energy_J, 6.0, by_precision(1e-6, 2e-15));
}

}  // namespace
}  // namespace polhode::testing
