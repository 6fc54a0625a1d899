// Multibodies without links in free flight get the same bits as rigid bodies, whatever Bullet's multibody
// class does in a step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/free_top.h"
#include "polhode/bullet/conversions.h"
#include "support/both_ways.h"
#include "support/multibody_scene.h"
#include "support/precision.h"
#include "support/same_bits.h"

namespace polhode::testing {
namespace {

const btScalar kDt = btScalar(1.0 / 60.0);
const btVector3 kInertia(1, 2, 3);
const btVector3 kNearMiddleAxis(1, 8, btScalar(0.5));
const btQuaternion kTilted(btVector3(1, 2, 3).normalized(), btScalar(0.7));

// The library computes moments from Bullet's rounded inverses, for multibodies too.
Vector3 rounded_moments(const btVector3& inertia_B) {
  const btVector3 inverse_B(1 / inertia_B.x(), 1 / inertia_B.y(), 1 / inertia_B.z());
  return to_double(inverse_B).cwiseInverse();
}

template <class Way>
class MultibodyInFlight : public ::testing::Test {
 protected:
  RotationState state_of(const btMultiBody& multibody) {
    return scene_.rotation().rotation_of(multibody).state;
  }

  Way scene_;
};
TYPED_TEST_SUITE(MultibodyInFlight, BothWaysOfMultibodies, WayName);

TYPED_TEST(MultibodyInFlight, HasTheBitsOfARigidBodyInEveryScheme) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    const std::string_view name = scheme->description().name;
    TypeParam scene;
    scene.rotation().set_default_scheme(name);
    const btRigidBody& body = scene.add_free(kInertia, kNearMiddleAxis, kTilted);
    const btMultiBody& multibody = scene.add_free_multibody(kInertia, kNearMiddleAxis, kTilted);
    // A multibody stores the inverse quaternion, which rounds differently from a rigid body's matrix.
    const double start_apart = scene.rotation().rotation_of(multibody).state.q_WB.angularDistance(
        scene.rotation().rotation_of(body).state.q_WB);
    EXPECT_LE(start_apart, by_precision(3e-7, 1e-15)) << name;  // measured 8e-8 and 0
    scene.step(kDt, 20);
    EXPECT_EQ(scene.rotation().rotation_of(multibody).steps, 20U) << name;
  }
  // Starts from an orientation that both store exactly.
  for (const SchemePointer& scheme : built_in_schemes()) {
    const std::string_view name = scheme->description().name;
    TypeParam scene;
    scene.rotation().set_default_scheme(name);
    const btRigidBody& body = scene.add_free(kInertia, kNearMiddleAxis);
    const btMultiBody& multibody = scene.add_free_multibody(kInertia, kNearMiddleAxis);
    scene.step(kDt, 200);
    EXPECT_TRUE(
        same_bits(scene.rotation().rotation_of(multibody).state, scene.rotation().rotation_of(body).state))
        << name;
    EXPECT_EQ(multibody.getBaseOmega(), body.getAngularVelocity()) << name;
  }
}

TYPED_TEST(MultibodyInFlight, KeepsEnergyAndMomentumForAnHour) {
  const btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kNearMiddleAxis, kTilted);
  const RotationState start = this->state_of(multibody);
  this->scene_.step(kDt, 60 * 3600);
  const RotationState end = this->state_of(multibody);
  EXPECT_EQ(end.L_W, start.L_W);
  EXPECT_LE(std::abs(end.energy() / start.energy() - 1.0), 1e-13);  // measured 0 in both precisions
  // Bullet's multibody stores the rounded state; measured 2.0e-7 in single, 2e-16 in double precision.
  EXPECT_NEAR(shown_rotational_energy(multibody) / start.energy(), 1.0, by_precision(1e-6, 1e-14));
}

TEST(MultibodyInBullet, GainsEnergy) {
  MultibodyScene<> plain;
  const btMultiBody& multibody = plain.add_free_multibody(kInertia, kNearMiddleAxis, kTilted);
  const double start = shown_rotational_energy(multibody);
  plain.step(kDt, 3600);
  EXPECT_GE(shown_rotational_energy(multibody) / start,
            100.0);  // measured 205 in single, 290 in double precision
}

TYPED_TEST(MultibodyInFlight, TurnsAsTheClosedFormSays) {
  const btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kNearMiddleAxis, kTilted);
  const RotationState start = this->state_of(multibody);
  const oracle::FreeTop truth(rounded_moments(kInertia), start.q_WB, start.L_W);
  this->scene_.step(kDt, 600);
  EXPECT_LE(truth.attitude_error_after(this->state_of(multibody).q_WB, 600, kDt), 1e-12);  // measured 4e-14
}

// Bullet clamps each velocity coordinate of a multibody to 100, which changes the axis of a fast spin.
TYPED_TEST(MultibodyInFlight, KeepsASpinBeyondTheLargestCoordinate) {
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, btVector3(30, 180, 90));
  const RotationState start = this->state_of(multibody);
  this->scene_.step(kDt, 100);
  EXPECT_EQ(this->state_of(multibody).L_W, start.L_W);
  EXPECT_EQ(multibody.getMaxCoordinateVelocity(), btScalar(100));
}

TYPED_TEST(MultibodyInFlight, IsPushedByATorqueLikeARigidBody) {
  btRigidBody& body = this->scene_.add_free(kInertia, kNearMiddleAxis);
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kNearMiddleAxis);
  const btVector3 torque_W(btScalar(0.3), btScalar(-0.2), btScalar(0.5));
  for (int i = 0; i < 120; ++i) {
    body.applyTorque(torque_W);
    multibody.addBaseTorque(torque_W);
    this->scene_.step(kDt);
  }
  const RotationState of_body = this->scene_.rotation().rotation_of(body).state;
  // measured 0 in both precisions: a torque that acts alone is applied in double
  EXPECT_LE((this->state_of(multibody).L_W - of_body.L_W).norm(), 1e-12);
  EXPECT_LE(this->state_of(multibody).q_WB.angularDistance(of_body.q_WB), 1e-12);
}

// Bullet's damping of multibodies: the energy decays at the rate 2 k (1 + |omega|) per second.
TYPED_TEST(MultibodyInFlight, IsDampedAsBulletDampsMultibodies) {
  const auto damped = [](auto& scene) -> btMultiBody& {
    btMultiBody& multibody = scene.add_free_multibody(btVector3(2, 2, 2), btVector3(1, 2, 2));
    multibody.setAngularDamping(btScalar(0.04));
    return multibody;
  };
  MultibodyScene<> plain;
  const btMultiBody& expected = damped(plain);
  const btMultiBody& multibody = damped(this->scene_);
  plain.step(kDt, 600);
  this->scene_.step(kDt, 600);
  // measured 3.9e-7 in single, 0 in double precision
  EXPECT_NEAR(shown_rotational_energy(multibody) / shown_rotational_energy(expected), 1.0,
              by_precision(1e-5, 1e-13));
}

TYPED_TEST(MultibodyInFlight, GoesOnFromWhatTheApplicationSets) {
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kNearMiddleAxis);
  this->scene_.step(kDt, 10);
  multibody.setBaseOmega(btVector3(0, 0, 5));
  multibody.setWorldToBaseRot(btQuaternion::getIdentity());
  multibody.setBaseInertia(btVector3(4, 5, 6));
  this->scene_.step(kDt, 10);
  const RotationState state = this->state_of(multibody);
  EXPECT_LE((state.L_W - Vector3(0, 0, 30)).norm(), by_precision(5e-6, 1e-12));  // measured 9e-7 and 0
  const double turned = 10 * 5.0 * static_cast<double>(kDt);
  EXPECT_NEAR(2 * std::atan2(state.q_WB.z(), state.q_WB.w()), turned, 1e-12);
}

TYPED_TEST(MultibodyInFlight, KeepsItsOrientationInDoubleUnderAnotherInertia) {
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kNearMiddleAxis);
  this->scene_.step(kDt, 10);
  const RotationState before = this->state_of(multibody);
  multibody.setBaseInertia(btVector3(4, 5, 6));
  const RotationState after = this->state_of(multibody);
  EXPECT_TRUE(same_bits(after.q_WB.coeffs(), before.q_WB.coeffs()));
  EXPECT_LE((after.omega_W - before.omega_W).norm(), by_precision(1e-6, 1e-14));  // measured 3e-7 and 0
}

TYPED_TEST(MultibodyInFlight, MovesItsBaseAsBulletDoes) {
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kNearMiddleAxis);
  const btVector3 start = multibody.getBasePos();
  multibody.setBaseVel(btVector3(1, 2, 3));
  this->scene_.step(kDt, 60);
  // measured 1.8e-4 m in single, 1.7e-13 m in double precision: 60 roundings at 100 m
  EXPECT_NEAR((multibody.getBasePos() - start).distance(btVector3(1, 2, 3)), 0.0, by_precision(1e-3, 1e-12));
}

TYPED_TEST(MultibodyInFlight, ShowsItsColliderWhereItIs) {
  btMultiBody& multibody = this->scene_.add_multibody_box(btVector3(1, 2, 3), 1, btTransform(kTilted));
  multibody.setBaseOmega(kNearMiddleAxis);
  this->scene_.step(kDt, 7);
  const btMatrix3x3 basis(multibody.getWorldToBaseRot().inverse());
  EXPECT_EQ(multibody.getBaseCollider()->getWorldTransform().getBasis(), basis);
  EXPECT_EQ(multibody.getBaseCollider()->getInterpolationWorldTransform().getBasis(), basis);
  EXPECT_EQ(multibody.getBaseCollider()->getWorldTransform().getOrigin(), multibody.getBasePos());
}

TYPED_TEST(MultibodyInFlight, IsRotatedUnderRungeKuttaToo) {
  btMultiBody& multibody = this->scene_.add_free_multibody(kInertia, kNearMiddleAxis);
  multibody.useRK4Integration(true);
  const RotationState start = this->state_of(multibody);
  this->scene_.step(kDt, 60);
  EXPECT_EQ(this->state_of(multibody).L_W, start.L_W);
}

TEST(MultibodyBothWays, HaveTheSameBits) {
  const auto play = [](auto& scene) {
    std::vector<btScalar> numbers;
    scene.world().setGravity(btVector3(0, 0, -10));
    scene.add_floor();
    for (int i = 0; i < 6; ++i) {
      const btVector3 place(btScalar(0.3) * btScalar(i), 0, btScalar(1 + i));
      btMultiBody& multibody = scene.add_multibody_box(btVector3(btScalar(0.2), btScalar(0.3), btScalar(0.5)),
                                                       1, btTransform(kTilted, place));
      multibody.setBaseOmega(btVector3(3, btScalar(i), 5));
      multibody.setAngularDamping(btScalar(0.04));
      scene.add_box(btVector3(btScalar(0.2), btScalar(0.3), btScalar(0.4)), 1,
                    btTransform(kTilted, place + btVector3(0, 1, 0)));
    }
    scene.step(kDt, 200);
    for (int i = 0; i < scene.world().getNumMultibodies(); ++i) {
      const btMultiBody& multibody = *scene.world().getMultiBody(i);
      for (int k = 0; k < 6; ++k) numbers.push_back(multibody.getVelocityVector()[k]);
      for (int k = 0; k < 3; ++k) numbers.push_back(multibody.getBasePos()[k]);
      for (int k = 0; k < 4; ++k) numbers.push_back(multibody.getWorldToBaseRot()[k]);
    }
    return numbers;
  };
  MultibodiesInRotationWorld in_world;
  MultibodiesUnderRotationPlugin under_plugin;
  EXPECT_EQ(play(in_world), play(under_plugin));
}

}  // namespace
}  // namespace polhode::testing
