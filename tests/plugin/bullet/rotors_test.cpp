// Rotors inside bodies of Bullet's worlds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "oracle/taylor_top.h"
#include "polhode/rotation_math.h"
#include "polhode/scheme_registry.h"
#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/free_motion_reference.h"
#include "support/motion.h"
#include "support/multibody_scene.h"
#include "support/precision.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using ::testing::AllOf;
using testing::angle_between;
using testing::BothWays;
using testing::by_precision;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Property;
using testing::same_bits;
using ::testing::Throws;
using testing::vector;
using testing::WayName;

const btScalar kDt = btScalar(1.0 / 60.0);
const Vector3 kRotor_B(2.0, -3.0, 5.0);

// Returns L_W computed from omega_W and h.
Vector3 sum_W(const RotationState& state, const Vector3& inertia_B) {
  return state.R_WB *
         (inertia_B.cwiseProduct(state.R_WB.transpose() * state.omega_W) + state.rotor_momentum_B);
}

template <class Way>
class RotorsOfBodies : public ::testing::Test {
 protected:
  RotationControl& rotation() { return scene_.rotation(); }
  RotationState state(const btRigidBody& body) { return scene_.rotation().rotation_of(body).state; }

  Way scene_;
  btRigidBody& body_ = scene_.add_free(vector(1, 2, 4), vector(0.5, 2, -0.75));
  const Vector3 inertia_B_{1, 2, 4};
};
TYPED_TEST_SUITE(RotorsOfBodies, BothWays, WayName);

TYPED_TEST(RotorsOfBodies, FollowTheOracle) {
  this->rotation().set_rotor_momentum(this->body_, kRotor_B, RotorChange::from_outside);
  const RotationState start = this->state(this->body_);
  oracle::TaylorTop oracle(this->inertia_B_, start.q_WB, start.L_W, kRotor_B);
  this->scene_.step(kDt, 600);
  oracle.advance(600 * static_cast<double>(kDt));
  const RotationState end = this->state(this->body_);
  EXPECT_LE(oracle.attitude_error(end.q_WB), 1e-12);  // measured 1.6e-14
  EXPECT_EQ(end.L_W, start.L_W);
  EXPECT_TRUE(testing::shows(this->body_, end));
}

TYPED_TEST(RotorsOfBodies, ChangedByAMotorKeepTheWholeMomentum) {
  this->scene_.step(kDt, 3);
  const RotationState before = this->state(this->body_);
  this->rotation().set_rotor_momentum(this->body_, kRotor_B, RotorChange::by_motor);
  const RotationState after = this->state(this->body_);
  EXPECT_EQ(after.L_W, before.L_W);
  EXPECT_EQ(after.rotor_momentum_B, kRotor_B);
  EXPECT_LE((sum_W(after, this->inertia_B_) - after.L_W).norm(), 1e-14 * after.L_W.norm());
  const Vector3 change_B = after.R_WB.transpose() * (after.omega_W - before.omega_W);
  EXPECT_LE((change_B + kRotor_B.cwiseQuotient(this->inertia_B_)).norm(), 1e-14);
  EXPECT_TRUE(testing::shows(this->body_, after));
  this->scene_.step(kDt, 100);
  EXPECT_EQ(this->state(this->body_).L_W, before.L_W);
}

TYPED_TEST(RotorsOfBodies, ChangedFromOutsideKeepTheVelocity) {
  this->scene_.step(kDt, 3);
  const RotationState before = this->state(this->body_);
  this->rotation().set_rotor_momentum(this->body_, kRotor_B, RotorChange::from_outside);
  const RotationState after = this->state(this->body_);
  EXPECT_EQ(after.omega_W, before.omega_W);
  EXPECT_LE((after.L_W - before.L_W - before.R_WB * kRotor_B).norm(), 1e-14);
  this->scene_.step(kDt, 100);
  EXPECT_EQ(this->state(this->body_).L_W, after.L_W);
}

TYPED_TEST(RotorsOfBodies, OfNoMomentumAreNone) {
  btRigidBody& other = this->scene_.add_free(vector(1, 2, 4), vector(0.5, 2, -0.75));
  this->rotation().set_rotor_momentum(other, Vector3::Zero(), RotorChange::by_motor);
  this->scene_.step(kDt, 50);
  EXPECT_TRUE(same_bits(this->state(other), this->state(this->body_)));
  this->rotation().set_rotor_momentum(other, kRotor_B, RotorChange::by_motor);
  this->scene_.step(kDt);
  this->rotation().set_rotor_momentum(other, Vector3::Zero(), RotorChange::by_motor);
  EXPECT_FALSE(this->state(other).has_rotor());
}

TYPED_TEST(RotorsOfBodies, AreRampedByTheirMotors) {
  const RotationState before = this->state(this->body_);
  const Vector3 torque_B(0.25, 0.5, -1.0);
  this->rotation().set_rotor_torque(this->body_, torque_B);
  this->scene_.step(kDt, 90);
  this->rotation().set_rotor_torque(this->body_, Vector3::Zero());
  const RotationState after = this->state(this->body_);
  this->scene_.step(kDt, 30);
  EXPECT_LE((after.rotor_momentum_B - 1.5 * torque_B).norm(), 1e-6);
  EXPECT_EQ(this->state(this->body_).rotor_momentum_B, after.rotor_momentum_B);
  EXPECT_EQ(this->state(this->body_).L_W, before.L_W);
  EXPECT_LE((sum_W(after, this->inertia_B_) - after.L_W).norm(), 1e-13);
}

// External actions change the momentum of the body, not of the rotor.
TYPED_TEST(RotorsOfBodies, GoOnThroughChangesFromOutside) {
  this->rotation().set_rotor_momentum(this->body_, kRotor_B, RotorChange::by_motor);
  this->scene_.step(kDt);
  const auto agrees = [&] {
    this->scene_.step(kDt);
    const RotationState now = this->state(this->body_);
    EXPECT_EQ(now.rotor_momentum_B, kRotor_B);
    EXPECT_LE((sum_W(now, this->inertia_B_) - now.L_W).norm(), 1e-13);
  };
  this->body_.setAngularVelocity(vector(1, 1, 0));
  agrees();
  this->body_.setCenterOfMassTransform(btTransform(btQuaternion(vector(1, 0, 0), 1), vector(0, 0, 0)));
  agrees();
  this->body_.applyTorqueImpulse(vector(0.5, 0, 0.25));
  agrees();
  this->body_.setDamping(btScalar(0.1), btScalar(0.5));
  agrees();
  this->body_.setDamping(0, 0);
  this->scene_.world().removeRigidBody(&this->body_);
  this->scene_.world().addRigidBody(&this->body_);
  agrees();
  this->rotation().set_scheme(this->body_, "rk4");
  agrees();
}

// The momentum after a kick follows from the new velocity and the rotor.
TYPED_TEST(RotorsOfBodies, HaveTheirPartOfTheMomentumAfterAKick) {
  for (const SchemePointer& scheme : built_in_schemes()) {
    if (!scheme->description().takes_rotors) continue;
    this->rotation().set_scheme(this->body_, scheme);
    this->rotation().set_rotor_momentum(this->body_, kRotor_B, RotorChange::from_outside);
    this->scene_.step(kDt);
    RotationState kicked = this->state(this->body_);
    kicked.omega_W = Vector3(1.0, 1.0, 0.5);
    const Vector3 expected_L_W = sum_W(kicked, this->inertia_B_);
    this->body_.setAngularVelocity(vector(1, 1, 0.5));
    this->scene_.step(btScalar(1e-4));
    EXPECT_LE((this->state(this->body_).L_W - expected_L_W).norm(), 3e-3) << scheme->description().name;
    EXPECT_LE((this->state(this->body_).omega_W - kicked.omega_W).norm(), 3e-3) << scheme->description().name;
  }
}

// Damping acts on the velocity of the body; the rotor keeps its momentum.
TYPED_TEST(RotorsOfBodies, AreNotDamped) {
  this->rotation().set_rotor_momentum(this->body_, kRotor_B, RotorChange::by_motor);
  this->body_.setDamping(0, btScalar(0.9));
  this->scene_.step(kDt, 1200);
  const RotationState end = this->state(this->body_);
  EXPECT_LE(end.omega_W.norm(), 1e-3);
  EXPECT_LE((end.L_W - end.R_WB * kRotor_B).norm(), 1e-2);
}

// A gyroscope, a wheel in a light frame, hangs on a cord and precesses at m g l / h.
TYPED_TEST(RotorsOfBodies, PrecessOnAPointJoint) {
  const double h = 4.0;
  const double length = 0.5;
  testing::set_gravity(this->scene_);
  for (const char* const scheme : {"exact", "rk4", "implicit_midpoint"}) {
    btRigidBody& body =
        this->scene_.add(1, vector(0.1, 0.1, 0.15),
                         btTransform(btQuaternion(vector(0, 1, 0), btScalar(M_PI / 2)), vector(length, 0, 0)),
                         this->scene_.box(vector(0.1, 0.1, 0.1)));
    body.getWorldTransform().setOrigin(
        vector(length, 5.0 * static_cast<double>(this->scene_.bodies().size()), 0));
    body.setInterpolationWorldTransform(body.getWorldTransform());
    this->scene_.template join<btPoint2PointConstraint>(body, vector(0, 0, -length));
    this->rotation().set_scheme(body, scheme);
    this->rotation().set_rotor_momentum(body, {0.0, 0.0, h}, RotorChange::from_outside);
    const double rate = testing::kGravity * length / h;
    body.setAngularVelocity(vector(0, 0, rate));
    body.setLinearVelocity(vector(0, rate * length, 0));
    testing::Range height;
    const Vector3 pivot = to_double(body.getWorldTransform().getOrigin()) - Vector3(length, 0, 0);
    double angle = 0.0;
    Vector3 before = Vector3::UnitX();
    for (int i = 0; i < 600; ++i) {
      this->scene_.world().stepSimulation(kDt, 0, kDt);
      const Vector3 arm = to_double(body.getWorldTransform().getOrigin()) - pivot;
      height.add(arm.z());
      angle += std::atan2(before.cross(arm).z(), before.dot(arm));
      before = arm;
    }
    EXPECT_NEAR(angle / (10.0 * rate), 1.0, 0.02) << scheme;
    EXPECT_LE(height.highest - height.lowest, 0.02) << scheme;
    this->scene_.world().removeRigidBody(&body);
  }
}

// A box with a wheel falls, tumbles over the floor and comes to rest.
TYPED_TEST(RotorsOfBodies, GainNoEnergyInContacts) {
  testing::set_gravity(this->scene_);
  this->scene_.world().removeRigidBody(&this->body_);
  this->scene_.add_floor();
  btRigidBody& box = this->scene_.add_box(
      vector(0.2, 0.3, 0.4), 1, btTransform(btQuaternion(vector(1, 2, 0.5), btScalar(0.7)), vector(0, 0, 2)));
  this->rotation().set_rotor_momentum(box, {0.3, -0.2, 1.0}, RotorChange::from_outside);
  const double start = testing::energy_of(box, testing::kGravity);
  double highest = start;
  for (int i = 0; i < 1200; ++i) {
    this->scene_.step(kDt);
    highest = std::max(highest, testing::energy_of(box, testing::kGravity));
  }
  EXPECT_LE(highest, start);
  EXPECT_LE(testing::omega_of(box).norm(), 0.3);
  EXPECT_EQ(this->rotation().incidents(), 0U);
}

TYPED_TEST(RotorsOfBodies, TurnAHingedBodyAgainstTheirMotors) {
  this->body_.setAngularVelocity(vector(0, 0, 0));
  this->scene_.template join<btHingeConstraint>(this->body_, vector(0, 0, 0), vector(0, 0, 1));
  this->rotation().set_rotor_momentum(this->body_, {0.5, 0.0, 0.0}, RotorChange::from_outside);
  this->rotation().set_rotor_torque(this->body_, {0.0, 0.0, 0.4});
  this->scene_.step(kDt, 60);
  // In a joint Bullet's velocity is the mean over the step.
  EXPECT_NEAR(testing::omega_of(this->body_).z(), -0.1 * (1.0 - 0.5 / 60.0), 1e-6);  // measured 7.4e-8
  EXPECT_NEAR(this->state(this->body_).rotor_momentum_B.z(), 0.4, 1e-6);
  const Vector3 axis_W = testing::basis_of(this->body_) * Vector3::UnitZ();
  EXPECT_LE(testing::angle_between_axes(axis_W, Vector3::UnitZ()), by_precision(1e-4, 1e-6));
}

TYPED_TEST(RotorsOfBodies, OfALockedBodyAreTurnedToo) {
  this->body_.setAngularVelocity(vector(0, 0, 0));
  this->body_.setAngularFactor(vector(0, 0, 1));
  this->rotation().set_rotor_torque(this->body_, {0.0, 0.0, 0.4});
  for (const SchemePointer& scheme : built_in_schemes()) {
    if (!scheme->description().takes_rotors) continue;
    this->rotation().set_scheme(this->body_, scheme);
    this->body_.setAngularVelocity(vector(0, 0, 0));
    const double before = this->state(this->body_).rotor_momentum_B.z();
    this->scene_.step(kDt, 60);
    EXPECT_NEAR(testing::omega_of(this->body_).z(), -0.1, 1e-4) << scheme->description().name;
    EXPECT_NEAR(this->state(this->body_).rotor_momentum_B.z() - before, 0.4, 1e-6);
  }
}

TYPED_TEST(RotorsOfBodies, DoNotTurnABodyAboutAnAxisThatItDoesNotTurnAbout) {
  btRigidBody& body = this->scene_.add_free(vector(0, 0, 4), vector(0, 0, 1));
  this->rotation().set_rotor_momentum(body, {1.0, 2.0, 2.0}, RotorChange::by_motor);
  EXPECT_TRUE(same(body.getAngularVelocity(), vector(0, 0, 0.5)));
  btRigidBody& rigid = this->scene_.add_free(vector(0, 0, 0), vector(0, 0, 0));
  this->rotation().set_rotor_momentum(rigid, {1.0, 2.0, 2.0}, RotorChange::by_motor);
  this->rotation().set_rotor_torque(rigid, {1.0, 2.0, 2.0});
  this->scene_.step(kDt, 20);
  EXPECT_NEAR(testing::omega_of(body).z(), 0.5, 1e-6);
  EXPECT_EQ(testing::omega_of(rigid), Vector3::Zero());
  EXPECT_EQ(this->rotation().incidents(), 0U);
}

TYPED_TEST(RotorsOfBodies, AreRefusedForSchemesThatTakeNone) {
  RotationControl& rotation = this->rotation();
  const auto is_refused = [](const auto& call) {
    EXPECT_THAT(call, Throws<std::invalid_argument>(
                          Property(&std::invalid_argument::what,
                                   AllOf(HasSubstr("'matrix' takes no rotors"),
                                         HasSubstr("exact, quaternion"), Not(HasSubstr("moser"))))));
  };
  rotation.set_scheme(this->body_, "matrix");
  is_refused([&] { rotation.set_rotor_momentum(this->body_, kRotor_B, RotorChange::by_motor); });
  is_refused([&] { rotation.set_rotor_torque(this->body_, kRotor_B); });
  rotation.use_default_scheme(this->body_);
  rotation.set_rotor_momentum(this->body_, kRotor_B, RotorChange::by_motor);
  is_refused([&] { rotation.set_scheme(this->body_, "matrix"); });
  is_refused([&] { rotation.set_default_scheme("matrix"); });
  this->scene_.step(kDt);
  EXPECT_EQ(rotation.rotation_of(this->body_).scheme, "exact");
  EXPECT_EQ(this->state(this->body_).rotor_momentum_B, kRotor_B);
  rotation.release(this->body_);
  EXPECT_NO_THROW(rotation.set_default_scheme("matrix"));
}

TYPED_TEST(RotorsOfBodies, OfNumbersThatAreNotFiniteAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(this->rotation().set_rotor_momentum(this->body_, {nan, 0.0, 0.0}, RotorChange::by_motor),
               std::invalid_argument);
  EXPECT_THROW(this->rotation().set_rotor_torque(this->body_, {0.0, 0.0, 1.0 / 0.0}), std::invalid_argument);
  EXPECT_FALSE(this->state(this->body_).has_rotor());
}

TEST(RotorsOfMultibodies, AreThoseOfARigidBody) {
  testing::MultibodyScene<RotationWorld<btMultiBodyDynamicsWorld>> scene;
  btMultiBody& multibody = scene.add_free_multibody(vector(1, 2, 4), vector(0.5, 2, -0.75));
  btRigidBody& body = scene.add_free(vector(1, 2, 4), vector(0.5, 2, -0.75));
  RotationControl& rotation = scene.world().rotation();
  rotation.set_rotor_momentum(multibody, kRotor_B, RotorChange::by_motor);
  rotation.set_rotor_momentum(body, kRotor_B, RotorChange::by_motor);
  EXPECT_TRUE(same(multibody.getBaseOmega(), body.getAngularVelocity()));
  rotation.set_rotor_torque(multibody, {0.1, 0.2, 0.3});
  rotation.set_rotor_torque(body, {0.1, 0.2, 0.3});
  scene.step(kDt, 100);
  EXPECT_TRUE(same_bits(rotation.rotation_of(multibody).state, rotation.rotation_of(body).state));
  EXPECT_EQ(rotation.rotation_of(multibody).state.rotor_momentum_B,
            rotation.rotation_of(body).state.rotor_momentum_B);
}

}  // namespace
}  // namespace polhode
