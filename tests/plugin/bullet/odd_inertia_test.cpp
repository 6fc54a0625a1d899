// Moments of inertia that no real body has, and of any magnitude.
#include <gtest/gtest.h>

#include <cmath>

#include "support/both_ways.h"
#include "support/motion.h"
#include "support/precision.h"
#include "support/wide_batch.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 64);
const btQuaternion kTilted(btVector3(1, 2, 3).normalized(), btScalar(0.7));

template <class Way>
btRigidBody& add(Way& scene, const SchemePointer& scheme, const btVector3& inertia_B,
                 const btVector3& omega_W) {
  btRigidBody& body = scene.add_free(inertia_B, omega_W, kTilted);
  scene.rotation().set_scheme(body, scheme);
  return body;
}

template <class Way>
class OddInertia : public ::testing::Test {};
TYPED_TEST_SUITE(OddInertia, BothWays, WayName);

// The handout's T: 24.1449 + 28.436 < 118.812.
TYPED_TEST(OddInertia, ThatBreaksTheTriangleInequalityRuns) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    TypeParam scene;
    btRigidBody& body = add(scene, scheme, vector(24.1449, 28.436, 118.812), vector(0.1, 10, 0));
    RotationState alone = scene.rotation().rotation_of(body).state;
    const Vector3 inertia_B = to_double(body.getInvInertiaDiagLocal()).cwiseInverse();
    RememberedBody remembered(*scheme);
    for (int i = 0; i < 50; ++i) {
      scene.step(kDt);
      remembered.step({inertia_B, Vector3::Zero(), kDt}, alone);
    }
    const BodyRotation rotation = scene.rotation().rotation_of(body);
    EXPECT_EQ(scene.rotation().incidents(), 0u);
    EXPECT_EQ(rotation.state.R_WB, alone.R_WB);
    EXPECT_EQ(rotation.state.omega_W, alone.omega_W);
    EXPECT_GT(rotation.energy_J, 0);
  }
}

// Free motion depends only on the ratios of the moments; scaling by a power of two changes no digit.
TYPED_TEST(OddInertia, OfAnySizeGivesTheSameMotion) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    TypeParam scene;
    const btVector3 inertia_B(1, 2, 3);
    btRigidBody& ordinary = add(scene, scheme, inertia_B, btVector3(3, 2, 4));
    btRigidBody& huge = add(scene, scheme, inertia_B * btScalar(std::ldexp(1, 20)), btVector3(3, 2, 4));
    btRigidBody& tiny = add(scene, scheme, inertia_B * btScalar(std::ldexp(1, -20)), btVector3(3, 2, 4));
    scene.step(kDt, 50);
    for (const btRigidBody* body : {&huge, &tiny}) {
      EXPECT_TRUE(same(body->getWorldTransform().getBasis(), ordinary.getWorldTransform().getBasis()));
      EXPECT_TRUE(same(body->getAngularVelocity(), ordinary.getAngularVelocity()));
    }
  }
}

// Moments twelve decades apart in one body: its motion stays finite, and a failing scheme is reported.
TYPED_TEST(OddInertia, OfTwelveDecadesInOneBodyStaysFinite) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    TypeParam scene;
    btRigidBody& body = add(scene, scheme, vector(1e-6, 1, 1e6), vector(0.3, 0.2, 0.4));
    scene.step(kDt, 100);
    EXPECT_TRUE(basis_of(body).allFinite());
    EXPECT_TRUE(omega_of(body).allFinite());
    const BodyRotation rotation = scene.rotation().rotation_of(body);
    EXPECT_TRUE(rotation.state.all_finite());
    EXPECT_EQ(scene.rotation().incidents(), rotation.diverged ? 1u : 0u);
  }
}

// Also under a torque: the tiny body spins up a million times as fast as the medium one.
TYPED_TEST(OddInertia, SpinsUpInProportion) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    TypeParam scene;
    for (const double inertia : {1e-6, 1.0, 1e6}) {
      btRigidBody& body = add(scene, scheme, vector(inertia, inertia, inertia), btVector3(0, 0, 0));
      body.applyTorque(vector(0, 0, 64 * inertia));
      scene.step(kDt);
      // measured 1.2e-7 in single, 2.3e-16 in double precision
      EXPECT_NEAR(omega_of(body).z(), 1, by_precision(5e-7, 1e-15));
    }
  }
}

}  // namespace
}  // namespace polhode::testing
