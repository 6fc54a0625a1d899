// Torque laws of bodies in Bullet's worlds.
#include "polhode/torque_laws.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "polhode/scheme_registry.h"
#include "scheme_base/driven_step.h"
#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/driven_reference.h"
#include "support/free_motion_reference.h"
#include "support/motion.h"
#include "support/multibody_scene.h"
#include "support/precision.h"
#include "support/same_bits.h"

namespace polhode {
namespace {

using testing::angle_between;
using testing::BothWays;
using testing::by_precision;
using ::testing::HasSubstr;
using ::testing::Property;
using testing::same_bits;
using ::testing::Throws;
using testing::vector;
using testing::WayName;

constexpr double kRate = 60.0;
const btScalar kDt = btScalar(1.0 / kRate);

RotationState state_of(const btRigidBody& body, const Vector3& inertia_B) {
  return testing::state_from(inertia_B, to_quaternion(body.getWorldTransform().getBasis()),
                             testing::omega_of(body));
}

// Depends on all inputs of a law.
Torque of_everything(const TorqueLawInput& motion) {
  const Vector3 pull_W = (motion.q_WB * Vector3::UnitX()).cross(Vector3(0.6, 0.0, 0.8));
  return Torque(WorldTorque{pull_W * std::cos(3.0 * motion.time_s) +
                            0.01 * motion.position_W.cross(motion.velocity_W)}) +
         Torque(BodyTorque{-0.3 * motion.omega_B()});
}

template <class Way>
class TorqueLaws : public ::testing::Test {
 protected:
  Way scene_;
};
TYPED_TEST_SUITE(TorqueLaws, BothWays, WayName);

// A free body takes the scheme's own driven step, bit for bit, with RotationWorld and with RotationPlugin.
TYPED_TEST(TorqueLaws, OfAFreeBodyAreTheStepOfTheScheme) {
  const Vector3 inertia_B(1, 2, 3);
  for (const SchemePointer& scheme : built_in_schemes()) {
    for (const TorqueLawOrder order : {TorqueLawOrder::two, TorqueLawOrder::four}) {
      TypeParam scene;
      btRigidBody& body = scene.add_free(vector(1, 2, 3), vector(0.5, 2, -0.7));
      body.setLinearVelocity(vector(0.5, 0.25, 0));
      scene.rotation().set_scheme(body, scheme);
      scene.rotation().set_torque_law(body, of_everything, order);
      scene.rotation().set_time(2.0);
      Drive drive;
      drive.law = of_everything;
      drive.order = order;
      const Vector3 moments = to_double(body.getInvInertiaDiagLocal()).cwiseInverse();
      RotationState expected = state_of(body, moments);
      for (int i = 0; i < 100; ++i) {
        const StepStart start = {scene.rotation().time(), to_double(body.getWorldTransform().getOrigin()),
                                 to_double(body.getLinearVelocity())};
        const DrivenStep step = take_driven_step(
            *scheme, {moments, Vector3::Zero(), static_cast<double>(kDt)}, start, drive, expected);
        expected = step.end;
        drive.last_torque = step.last_torque;
        scene.step(kDt);
      }
      EXPECT_TRUE(same_bits(scene.rotation().rotation_of(body).state, expected))
          << scheme->description().name;
      EXPECT_NEAR(scene.rotation().time(), 2.0 + 100 / kRate, 1e-6);
      EXPECT_EQ(scene.rotation().incidents(), 0U);
    }
  }
}

// The error falls with dt^2, instead of dt for applyTorque.
TYPED_TEST(TorqueLaws, OfAConstantTorqueAreOfOrderTwo) {
  const Vector3 torque_W(1, -2, 3);
  const double duration = 1.0;
  const auto error = [&](int steps, bool by_law) {
    TypeParam scene;
    btRigidBody& body = scene.add_free(vector(1, 2, 4), vector(3, 2, 4));
    const Vector3 inertia_B(1, 2, 4);
    const TorqueLaw law = [torque_W](const TorqueLawInput&) { return WorldTorque{torque_W}; };
    if (by_law) scene.rotation().set_torque_law(body, law);
    const RotationState expected =
        testing::integrate_driven(inertia_B, state_of(body, inertia_B), {}, law, duration, 20000);
    const double dt = duration / steps;
    for (int i = 0; i < steps; ++i) {
      if (!by_law) body.applyTorque(to_bullet(torque_W));
      scene.step(static_cast<btScalar>(dt));
    }
    return angle_between(scene.rotation().rotation_of(body).state.q_WB, expected.q_WB);
  };
  // Powers of two: dt is the same in single precision.
  EXPECT_NEAR(std::log2(error(128, true) / error(256, true)), 2.0, 0.05);
  EXPECT_NEAR(std::log2(error(128, false) / error(256, false)), 1.0, 0.05);
  EXPECT_LE(error(128, true), 2e-4);
  EXPECT_GE(error(128, false), 10 * error(128, true));
}

// A rod, mounted askew on a hinge, swings on a spring about the hinge's axis. Bullet's solver gets the torque
// as part of the initial velocity.
TYPED_TEST(TorqueLaws, SwingABodyOnItsHinge) {
  const Vector3 inertia_B(1, 2, 3);
  btRigidBody& body =
      this->scene_.add_free(vector(1, 2, 3), vector(0, 0, 0), btQuaternion(vector(0, 1, 0), btScalar(0.5)));
  const btMatrix3x3 basis = body.getWorldTransform().getBasis();
  const Vector3 axis_B = to_double(basis).transpose() * Vector3::UnitZ();
  this->scene_.template join<btHingeConstraint>(body, vector(0, 0, 0), to_bullet(axis_B));
  const double moment = axis_B.dot(inertia_B.cwiseProduct(axis_B));
  const double omega = 2.0 * M_PI;  // one swing per second
  const double stiffness = moment * omega * omega;
  const Quaternion rest = to_quaternion(basis);
  this->scene_.rotation().set_torque_law(body, orientation_spring(rest, stiffness));
  body.setAngularVelocity(vector(0, 0, 1));
  double largest = 0.0;
  double largest_at_end = 0.0;
  int crossings = 0;
  double before = 1.0;
  for (int i = 0; i < 1200; ++i) {
    this->scene_.step(kDt);
    const double angle =
        logarithm(this->scene_.rotation().rotation_of(body).state.q_WB * rest.conjugate()).z();
    largest = std::max(largest, std::abs(angle));
    if (i >= 1080) largest_at_end = std::max(largest_at_end, std::abs(angle));
    crossings += (angle > 0.0) != (before > 0.0) ? 1 : 0;
    before = angle;
  }
  const Matrix3 R_WB = this->scene_.rotation().rotation_of(body).state.R_WB;
  EXPECT_LE(testing::angle_between_axes(R_WB * axis_B, Vector3::UnitZ()), by_precision(2e-5, 1e-9));
  EXPECT_NEAR(largest, 1.0 / omega, 0.01 / omega);
  EXPECT_NEAR(largest_at_end / largest, 1.0, 0.02);
  EXPECT_NEAR(crossings, 40, 1);
}

// A constant torque turns a locked body about its free axis as theory predicts.
TYPED_TEST(TorqueLaws, TurnABodyWithLockedAxesAboutTheFreeOne) {
  btRigidBody& body = this->scene_.add_free(vector(1, 2, 3), vector(0, 0, 0));
  body.setAngularFactor(vector(0, 0, 1));
  this->scene_.rotation().set_torque_law(
      body, [](const TorqueLawInput&) { return WorldTorque{Vector3(5, -4, 0.3)}; });
  this->scene_.step(kDt, 60);
  EXPECT_NEAR(testing::omega_of(body).z(), 0.1, 1e-5);
  EXPECT_EQ(testing::omega_of(body).x(), 0.0);
  EXPECT_EQ(testing::omega_of(body).y(), 0.0);
}

TYPED_TEST(TorqueLaws, ActOnABodyThatDoesNotTurnAboutAnAxisOfItsOwn) {
  btRigidBody& body = this->scene_.add_free(vector(0, 0, 3), vector(0, 0, 0));
  this->scene_.rotation().set_torque_law(
      body, [](const TorqueLawInput&) { return BodyTorque{Vector3(5, -4, 0.3)}; });
  this->scene_.step(kDt, 60);
  EXPECT_NEAR(testing::omega_of(body).z(), 0.1, 1e-5);
  EXPECT_EQ(testing::omega_of(body).x(), 0.0);
}

TYPED_TEST(TorqueLaws, ThatFailAreIncidentsAndTheBodyFliesOn) {
  btRigidBody& driven = this->scene_.add_free(vector(1, 2, 3), vector(0.5, 2, -0.7));
  btRigidBody& free = this->scene_.add_free(vector(1, 2, 3), vector(0.5, 2, -0.7));
  int reports = 0;
  this->scene_.rotation().set_incident_handler([&](const Incident& incident) {
    EXPECT_EQ(incident.kind, IncidentKind::torque_law_failed);
    EXPECT_EQ(incident.body, &driven);
    ++reports;
  });
  this->scene_.rotation().set_torque_law(
      driven, [](const TorqueLawInput&) -> Torque { throw std::runtime_error("no torque today"); });
  this->scene_.step(kDt, 20);
  EXPECT_EQ(reports, 1);
  EXPECT_EQ(this->scene_.rotation().incidents(), 20U);
  EXPECT_LE(angle_between(this->scene_.rotation().rotation_of(driven).state.q_WB,
                          this->scene_.rotation().rotation_of(free).state.q_WB),
            1e-13);
}

TYPED_TEST(TorqueLaws, ThatFailDoNotUpsetAJointOrALock) {
  btRigidBody& hinged = this->scene_.add_free(vector(1, 2, 3), vector(0, 0, 2));
  this->scene_.template join<btHingeConstraint>(hinged, vector(0, 0, 0), vector(0, 0, 1));
  btRigidBody& locked = this->scene_.add_free(vector(1, 2, 3), vector(0, 0, 2));
  locked.setAngularFactor(vector(0, 0, 1));
  for (btRigidBody* body : {&hinged, &locked}) {
    this->scene_.rotation().set_torque_law(
        *body, [](const TorqueLawInput& motion) { return BodyTorque{motion.omega_W / 0.0}; });
  }
  this->scene_.step(kDt, 20);
  EXPECT_EQ(this->scene_.rotation().incidents(), 40U);
  EXPECT_NEAR(testing::omega_of(hinged).z(), 2.0, 1e-5);
  EXPECT_NEAR(testing::omega_of(locked).z(), 2.0, 1e-5);
}

TYPED_TEST(TorqueLaws, ThatBlowUpAreADivergedBody) {
  btRigidBody& body = this->scene_.add_free(vector(1, 2, 3), vector(0.5, 2, -0.7));
  this->scene_.rotation().set_torque_law(
      body, [](const TorqueLawInput& motion) { return BodyTorque{1e6 * motion.omega_B()}; });
  this->scene_.step(kDt, 50);
  EXPECT_TRUE(this->scene_.rotation().rotation_of(body).diverged);
  EXPECT_EQ(testing::omega_of(body), Vector3::Zero());
}

// A law persists as a body's scheme does.
TYPED_TEST(TorqueLaws, StayUntilTheBodyIsReleasedOrAbsentFromAStep) {
  btRigidBody& body = this->scene_.add_free(vector(1, 2, 3), vector(0, 0, 0));
  int asked = 0;
  const auto law = [&asked](const TorqueLawInput&) {
    ++asked;
    return Torque();
  };
  const auto is_asked = [&] {
    const int before = asked;
    this->scene_.step(kDt);
    return asked > before;
  };
  RotationControl& rotation = this->scene_.rotation();
  rotation.set_torque_law(body, law);
  EXPECT_TRUE(is_asked());
  this->scene_.world().removeRigidBody(&body);
  this->scene_.world().addRigidBody(&body);
  EXPECT_TRUE(is_asked());
  rotation.set_scheme(body, "rk4");
  EXPECT_TRUE(is_asked());
  rotation.set_default_scheme("quaternion");
  rotation.use_default_scheme(body);
  EXPECT_TRUE(is_asked());
  rotation.clear_torque_law(body);
  EXPECT_FALSE(is_asked());
  rotation.set_torque_law(body, law);
  rotation.release(body);
  rotation.use_default_scheme(body);
  EXPECT_FALSE(is_asked());
  rotation.set_torque_law(body, law);
  this->scene_.world().removeRigidBody(&body);
  this->scene_.step(kDt);
  this->scene_.world().addRigidBody(&body);
  EXPECT_FALSE(is_asked());
}

// Setting and clearing a law moves the body to other batches and back without any other effect.
TYPED_TEST(TorqueLaws, ComeAndGoWithoutATrace) {
  std::vector<btRigidBody*> bodies;
  for (int i = 0; i < 21; ++i) bodies.push_back(&this->scene_.add_free(vector(1, 2, 3), vector(1, i, 2)));
  this->scene_.step(kDt, 5);
  RotationControl& rotation = this->scene_.rotation();
  for (std::size_t i = 0; i < bodies.size(); i += 2) {
    const RotationState before = rotation.rotation_of(*bodies[i]).state;
    rotation.set_torque_law(*bodies[i], [](const TorqueLawInput&) { return Torque(); });
    EXPECT_TRUE(same_bits(rotation.rotation_of(*bodies[i]).state, before));
    EXPECT_EQ(rotation.rotation_of(*bodies[i]).steps, 5U);
    rotation.clear_torque_law(*bodies[i]);
    EXPECT_TRUE(same_bits(rotation.rotation_of(*bodies[i]).state, before));
  }
  for (btRigidBody* body : bodies) EXPECT_EQ(rotation.rotation_of(*body).steps, 5U);
  EXPECT_EQ(rotation.managed_bodies(), bodies.size());
}

TYPED_TEST(TorqueLaws, OfBodiesThatNoSchemeRotatesAreRefused) {
  const auto law = [](const TorqueLawInput&) { return Torque(); };
  RotationControl& rotation = this->scene_.rotation();
  btRigidBody& body = this->scene_.add_free(vector(1, 2, 3), vector(0, 0, 0));
  EXPECT_THAT(
      [&] { rotation.set_torque_law(body, nullptr); },
      Throws<std::invalid_argument>(Property(&std::invalid_argument::what, HasSubstr("empty function"))));
  btRigidBody& floor = this->scene_.add_floor();
  EXPECT_THAT([&] { rotation.set_torque_law(floor, law); },
              Throws<std::invalid_argument>(Property(&std::invalid_argument::what, HasSubstr("static"))));
  rotation.release(body);
  EXPECT_THROW(rotation.set_torque_law(body, law), std::invalid_argument);
  rotation.use_default_scheme(body);
  rotation.clear_default_scheme();
  EXPECT_THROW(rotation.set_torque_law(body, law), std::invalid_argument);
  EXPECT_THROW(rotation.set_time(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

// A multibody without links is driven like a rigid body.
TEST(TorqueLawsOfMultibodies, AreThoseOfARigidBody) {
  testing::MultibodyScene<RotationWorld<btMultiBodyDynamicsWorld>> scene;
  btMultiBody& multibody = scene.add_free_multibody(vector(1, 2, 3), vector(0.5, 2, -0.7));
  btRigidBody& body = scene.add_free(vector(1, 2, 3), vector(0.5, 2, -0.7));
  RotationControl& rotation = scene.world().rotation();
  const auto law = [](const TorqueLawInput& motion) {
    return Torque(WorldTorque{Vector3(0.1, std::sin(motion.time_s), 0.0)}) +
           Torque(BodyTorque{-0.2 * motion.omega_B()});
  };
  rotation.set_torque_law(multibody, law);
  rotation.set_torque_law(body, law);
  scene.step(kDt, 100);
  EXPECT_TRUE(same_bits(rotation.rotation_of(multibody).state, rotation.rotation_of(body).state));
  rotation.clear_torque_law(multibody);
  rotation.clear_torque_law(body);
  scene.step(kDt, 10);
  EXPECT_TRUE(same_bits(rotation.rotation_of(multibody).state, rotation.rotation_of(body).state));
}

}  // namespace
}  // namespace polhode
