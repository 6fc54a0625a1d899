// Torques act with every scheme; forces through the centre of mass do not turn the body.
#include <gtest/gtest.h>

#include "support/both_ways.h"
#include "support/free_motion_reference.h"
#include "support/motion.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr double kDt = 1.0 / 64;
const btQuaternion kTilted(btVector3(1, 2, 3).normalized(), btScalar(0.7));

template <class Way>
class Torque : public ::testing::Test {};
TYPED_TEST_SUITE(Torque, BothWays, WayName);

// With equal moments there is no gyroscopic term: I omega is the integral of the torque.
TYPED_TEST(Torque, SpinsUpASphericalBodyByItsIntegral) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    // A swollen body has other moments.
    if (scheme->description().rotation == Conservation::lost) continue;
    SCOPED_TRACE(scheme->description().name);
    TypeParam scene;
    btRigidBody& body = scene.add_free(btVector3(2, 2, 2), btVector3(0, 0, 0), kTilted);
    scene.rotation().set_scheme(body, scheme);
    for (int i = 0; i < 64; ++i) {
      body.applyTorque(btVector3(2, -1, 4));
      scene.step(btScalar(kDt));
    }
    const RotationState state = scene.rotation().rotation_of(body).state;
    // measured 5.6e-16 and 9.9e-16
    EXPECT_LT((state.omega_W - Vector3(1, -0.5, 2)).norm(), 3e-15);
    EXPECT_LT((state.L_W - Vector3(2, -1, 4)).norm(), 5e-15);
  }
}

// Immediately, and permanently if the scheme conserves momentum.
TYPED_TEST(Torque, ImpulseIsAChangeOfAngularMomentum) {
  const Vector3 impulse_W(2, -1, 4);
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    TypeParam scene;
    btRigidBody& body = scene.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0), kTilted);
    scene.rotation().set_scheme(body, scheme);
    scene.step(btScalar(kDt));
    body.applyTorqueImpulse(to_bullet(impulse_W));
    const auto L_W = [&] { return scene.rotation().rotation_of(body).state.L_W; };
    // measured 8.4e-8 in single, 1.9e-15 in double precision
    EXPECT_LT((L_W() - impulse_W).norm(), by_precision(5e-7, 1e-14));
    if (scheme->description().angular_momentum != Conservation::exact) continue;
    scene.step(btScalar(kDt), 10);
    EXPECT_LT((L_W() - impulse_W).norm(), by_precision(5e-7, 1e-14));  // measured the same
  }
}

template <class Way>
RotationState after_one_second(const SchemePointer& scheme, double dt) {
  Way scene;
  btRigidBody& body = scene.add_free(btVector3(1, 2, 4), vector(0.5, 1, -0.5), kTilted);
  scene.rotation().set_scheme(body, scheme);
  const int steps = static_cast<int>(1 / dt);
  for (int i = 0; i < steps; ++i) {
    body.applyTorque(btVector3(1, -2, 3));
    scene.step(btScalar(dt));
  }
  return scene.rotation().rotation_of(body).state;
}

// Halving the step at least halves the error.
TYPED_TEST(Torque, TurnsAnAsymmetricBodyAsEulersEquationsSay) {
  const Vector3 inertia_B(1, 2, 4);
  const Quaternion q_WB = to_quaternion(btMatrix3x3(kTilted));
  const RotationState start = state_from(inertia_B, q_WB, Vector3(0.5, 1, -0.5));
  const RotationState reference = integrate_finely(inertia_B, start, 1.0, 20000, Vector3(1, -2, 3));
  const RotationState free = integrate_finely(inertia_B, start, 1.0, 20000);
  EXPECT_GT((free.omega_W - reference.omega_W).norm(), 0.5);  // without the torque
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    const RotationState coarse = after_one_second<TypeParam>(scheme, 1.0 / 256);
    const RotationState fine = after_one_second<TypeParam>(scheme, 1.0 / 512);
    const double coarse_error = (coarse.omega_W - reference.omega_W).norm();
    const double fine_error = (fine.omega_W - reference.omega_W).norm();
    // measured up to 2.9e-3 rad/s
    EXPECT_LT(fine_error, 0.01);
    // measured 2.00
    EXPECT_GT(coarse_error / fine_error, 1.9);
  }
}

TYPED_TEST(Torque, IsNotMadeByGravityOrACentralForce) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    SCOPED_TRACE(scheme->description().name);
    TypeParam pulled_scene;
    TypeParam free_scene;
    pulled_scene.world().setGravity(btVector3(0, 0, -10));
    btRigidBody& pulled = pulled_scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4), kTilted);
    btRigidBody& free = free_scene.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4), kTilted);
    pulled_scene.rotation().set_scheme(pulled, scheme);
    free_scene.rotation().set_scheme(free, scheme);
    for (int i = 0; i < 60; ++i) {
      pulled.applyCentralForce(btVector3(5, 7, -3));
      pulled_scene.step(btScalar(kDt));
      free_scene.step(btScalar(kDt));
    }
    EXPECT_LT(pulled.getWorldTransform().getOrigin().z(), -1);
    EXPECT_TRUE(same(pulled.getWorldTransform().getBasis(), free.getWorldTransform().getBasis()));
    EXPECT_TRUE(same(pulled.getAngularVelocity(), free.getAngularVelocity()));
  }
}

}  // namespace
}  // namespace polhode::testing
