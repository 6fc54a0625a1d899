// Which body has which scheme: the world's default, its own, one that the application wrote, or none.
#include <gtest/gtest.h>

#include <memory>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "polhode/rotation_math.h"
#include "support/precision.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60.0);
const btVector3 kInertia(1, 2, 3);
const btVector3 kSpin(3, 2, 4);

// A scheme of the application's own: the exponential map at constant angular momentum.
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

TEST(RotationOf, TellsTheApplicationsVelocityBeforeAnyStep) {
  Scene<> scene;
  RotationPlugin plugin(scene.world());
  btRigidBody& body = scene.add_free(kInertia, kSpin);
  body.setAngularVelocity(btVector3(0, 0, 2));
  const BodyRotation rotation = plugin.rotation().rotation_of(body);
  EXPECT_EQ(rotation.state.omega_W, Vector3(0, 0, 2));
  // 3 kg m^2 about z; 1/3 is rounded in Bullet, measured 1.8e-7 in single precision, 0 in double
  EXPECT_NEAR(rotation.state.L_W.z(), 6.0, by_precision(1e-6, 2e-15));
  EXPECT_NEAR(rotation.energy_J, 6.0, by_precision(1e-6, 2e-15));
}

}  // namespace
}  // namespace polhode::testing
