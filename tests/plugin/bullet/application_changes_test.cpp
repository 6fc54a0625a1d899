// The library adopts changes that the application makes between two steps: the body moves like one that
// starts in the changed state. Everything else stays in the library's double precision.
#include <gtest/gtest.h>

#include <functional>

#include "support/both_ways.h"
#include "support/motion.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 64);
const btQuaternion kTilted(btVector3(1, 2, 3).normalized(), btScalar(0.7));

using Change = std::function<void(btRigidBody&)>;

btTransform elsewhere(const btRigidBody& body) {
  return btTransform(btQuaternion(btVector3(-2, 1, 1).normalized(), btScalar(2.1)),
                     body.getWorldTransform().getOrigin() + btVector3(0, 3, 0));
}

const Change kSetVelocity = [](btRigidBody& body) { body.setAngularVelocity(btVector3(-1, 5, 2)); };
const Change kSetWorldTransform = [](btRigidBody& body) { body.setWorldTransform(elsewhere(body)); };
const Change kSetCenterOfMassTransform = [](btRigidBody& body) {
  body.setCenterOfMassTransform(elsewhere(body));
};
const Change kSetMass = [](btRigidBody& body) {
  body.setMassProps(2, btVector3(3, 1, 2));
  body.updateInertiaTensor();
};
const Change kSetAll = [](btRigidBody& body) {
  kSetMass(body);
  kSetVelocity(body);
  kSetCenterOfMassTransform(body);
};

struct NamedChange {
  const char* name;
  Change change;
};
const NamedChange kChanges[] = {{"velocity", kSetVelocity},
                                {"world transform", kSetWorldTransform},
                                {"centre of mass transform", kSetCenterOfMassTransform},
                                {"mass properties", kSetMass},
                                {"all of them", kSetAll}};

template <class Scene>
btRigidBody& add_tumbling(Scene& scene, const SchemePointer& scheme) {
  btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4), kTilted);
  scene.rotation().set_scheme(body, scheme);
  return body;
}

template <class Scene>
void step(Scene& scene, int count) {
  for (int i = 0; i < count; ++i) {
    scene.step(kDt);
  }
}

template <class Way>
class ApplicationChanges : public ::testing::Test {};
TYPED_TEST_SUITE(ApplicationChanges, BothWays, WayName);

// Equal only to rounding: of the unchanged quantities, the new body knows Bullet's rounded values.
TYPED_TEST(ApplicationChanges, AreWhereABodyStartedAfreshWouldStart) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    if (scheme->description().rotation == Conservation::lost) continue;  // the new body is not swollen
    for (const auto& [name, change] : kChanges) {
      SCOPED_TRACE(std::string(scheme->description().name) + ", " + name);
      TypeParam scene;
      btRigidBody& body = add_tumbling(scene, scheme);
      step(scene, 20);
      change(body);
      TypeParam fresh_scene;
      btRigidBody& fresh = fresh_scene.add(1 / body.getInvMass(), body.getLocalInertia(),
                                           body.getWorldTransform(), *body.getCollisionShape());
      fresh.setAngularVelocity(body.getAngularVelocity());
      fresh_scene.rotation().set_scheme(fresh, scheme);
      step(scene, 20);
      step(fresh_scene, 20);
      // measured 9.0e-8 in single, 1.6e-15 in double precision
      EXPECT_LT(distance(basis_of(body), basis_of(fresh)), by_precision(4e-7, 6e-15));
      // measured 6e-7 in single, 5e-15 in double precision
      EXPECT_LT((omega_of(body) - omega_of(fresh)).norm(), by_precision(2e-6, 2e-14));
    }
  }
}

// With pose and velocity both set, nothing of the former state is left and results are bit-identical.
TYPED_TEST(ApplicationChanges, OfPoseAndVelocityLeaveNothingOfWhatWas) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    TypeParam scene;
    TypeParam fresh_scene;
    btRigidBody& body = add_tumbling(scene, scheme);
    btRigidBody& fresh = add_tumbling(fresh_scene, scheme);
    step(scene, 20);
    for (btRigidBody* either : {&body, &fresh}) kSetAll(*either);
    fresh.setCenterOfMassTransform(body.getWorldTransform());
    step(scene, 20);
    step(fresh_scene, 20);
    EXPECT_TRUE(same_motion(body, fresh));
  }
}

TYPED_TEST(ApplicationChanges, ShowInTheStateAtOnce) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    if (scheme->description().rotation == Conservation::lost) continue;  // a swollen body has other moments
    for (const auto& [name, change] : kChanges) {
      SCOPED_TRACE(name);
      TypeParam scene;
      btRigidBody& body = add_tumbling(scene, scheme);
      step(scene, 20);
      change(body);
      const RotationState state = scene.rotation().rotation_of(body).state;
      EXPECT_TRUE(same(body.getAngularVelocity(), to_bullet(state.omega_W)));
      const Matrix3 R_WB = basis_of(body);
      // measured 3.9e-8 in single, 2.3e-16 in double precision
      EXPECT_LT(distance(state.R_WB, R_WB), by_precision(2e-7, 1e-15));
      const Vector3 L_B = to_double(body.getLocalInertia()).cwiseProduct(R_WB.transpose() * omega_of(body));
      // measured 9.5e-7 in single, 1.5e-14 in double precision
      EXPECT_LT((state.L_W - R_WB * L_B).norm(), by_precision(4e-6, 6e-14));
    }
  }
}

// RotationWorld and RotationPlugin give the same bits for all changes.
TEST(ApplicationChangesUnderAPlugin, GiveTheBitsOfARotationWorld) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    for (const auto& [name, change] : kChanges) {
      SCOPED_TRACE(std::string(scheme->description().name) + ", " + name);
      InRotationWorld world_scene;
      UnderRotationPlugin plugin_scene;
      btRigidBody& in_world = add_tumbling(world_scene, scheme);
      btRigidBody& under_plugin = add_tumbling(plugin_scene, scheme);
      for (int round = 0; round < 3; ++round) {
        step(world_scene, 10);
        step(plugin_scene, 10);
        change(in_world);
        change(under_plugin);
      }
      step(world_scene, 1);
      step(plugin_scene, 1);
      EXPECT_TRUE(same_motion(in_world, under_plugin));
    }
  }
}

TYPED_TEST(ApplicationChanges, AreNotSeenInTheRoundedPose) {
  const SchemePointer scheme = find_scheme("quaternion");
  TypeParam scene;
  TypeParam read_back_scene;
  btRigidBody& body = add_tumbling(scene, scheme);
  btRigidBody& read_back = add_tumbling(read_back_scene, scheme);
  RotationState alone = scene.rotation().rotation_of(body).state;
  const StepInput free_step{to_double(body.getInvInertiaDiagLocal()).cwiseInverse(), Vector3::Zero(), kDt};
  for (int i = 0; i < 10000; ++i) {
    scene.step(kDt);
    scheme->step(free_step, alone);
    read_back_scene.step(kDt);
    read_back_scene.rotation().set_scheme(read_back, scheme);  // restarts from Bullet's rounded values
  }
  // The state is never rounded to Bullet's precision.
  const RotationState state = scene.rotation().rotation_of(body).state;
  EXPECT_EQ(state.q_WB.coeffs(), alone.q_WB.coeffs());
  EXPECT_EQ(state.omega_W, alone.omega_W);
  EXPECT_TRUE(shows(body, state));
  const double drift = angle_between(basis_of(read_back), alone.R_WB);
  // measured 1.4e-3 in single, 1.3e-9 in double precision
  EXPECT_GT(drift, by_precision(3e-4, 3e-10));
}

}  // namespace
}  // namespace polhode::testing
