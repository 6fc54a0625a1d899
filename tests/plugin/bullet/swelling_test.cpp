// `matrix` keeps a basis that is not a rotation. The swelling must be visible, but must not harm other
// bodies.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "polhode/rotation_limits.h"
#include "support/both_ways.h"
#include "support/motion.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 64);

template <class Way>
class Swelling : public ::testing::Test {
 protected:
  btRigidBody& add_swelling(double speed) {
    btRigidBody& body =
        scene_.add(1, btVector3(1, 1, 1), btTransform::getIdentity(), scene_.box(btVector3(1, 1, 1)));
    body.setAngularVelocity(vector(0, 0, speed));
    scene_.rotation().set_scheme(body, "matrix");
    return body;
  }

  Way scene_;
};
TYPED_TEST_SUITE(Swelling, BothWays, WayName);

// Each step multiplies the determinant by 1 + |omega|^2 dt^2, while Bullet always gets a rotation.
TYPED_TEST(Swelling, IsSeenInTheStateAndKeptFromBullet) {
  btRigidBody& body = this->add_swelling(16);
  this->scene_.step(kDt, 20);
  const double expected = std::pow(1 + 0.25 * 0.25, 20);  // 3.36
  const RotationState state = this->scene_.rotation().rotation_of(body).state;
  // measured 0
  EXPECT_NEAR(state.R_WB.determinant() / expected, 1, 1e-14);
  // measured 0
  EXPECT_NEAR(basis_of(body).determinant(), 1, by_precision(3e-7, 1e-15));
  EXPECT_TRUE(same(body.getWorldTransform().getBasis(), to_bullet(state.q_WB.toRotationMatrix())));
}

TYPED_TEST(Swelling, DoesNotDependOnWhatBulletMakesOfTheBasis) {
  btRigidBody& body = this->add_swelling(16);
  RotationState alone = this->scene_.rotation().rotation_of(body).state;
  for (int i = 0; i < 20; ++i) {
    this->scene_.step(kDt);
    find_scheme("matrix")->step({Vector3(1, 1, 1), Vector3::Zero(), kDt}, alone);
  }
  EXPECT_EQ(this->scene_.rotation().rotation_of(body).state.R_WB, alone.R_WB);
}

TEST(SwellingInARotationWorld, IsSeenInTheMotionState) {
  InRotationWorld scene;
  btDefaultMotionState motion_state;
  btRigidBody& body = scene.add(1, btVector3(1, 1, 1), btTransform::getIdentity(),
                                scene.box(btVector3(1, 1, 1)), &motion_state);
  body.setAngularVelocity(vector(0, 0, 16));
  scene.rotation().set_scheme(body, "matrix");
  scene.step(kDt, 20);
  const btMatrix3x3 shown = motion_state.m_graphicsWorldTrans.getBasis();
  EXPECT_GT(to_double(shown).determinant(), 3);
  EXPECT_TRUE(same(shown, to_bullet(scene.rotation().rotation_of(body).state.R_WB)));
}

// Between two steps the motion state gets the pose at that time, like those of all other bodies.
TEST(SwellingInARotationWorld, IsShownBetweenTwoStepsWhereBulletShowsIt) {
  for (const bool is_interpolated : {false, true}) {
    InRotationWorld scene;
    scene.world().setLatencyMotionStateInterpolation(is_interpolated);
    btDefaultMotionState swollen_state;
    btDefaultMotionState rigid_state(btTransform(btQuaternion::getIdentity(), vector(0, 0, 10)));
    const auto add = [&scene](btMotionState& motion_state) -> btRigidBody& {
      btRigidBody& body = scene.add(1, btVector3(1, 1, 1), btTransform::getIdentity(),
                                    scene.box(btVector3(1, 1, 1)), &motion_state);
      body.setAngularVelocity(vector(0, 0, 16));
      body.setLinearVelocity(vector(64, 0, 0));
      return body;
    };
    btRigidBody& swollen = add(swollen_state);
    add(rigid_state);
    scene.rotation().set_scheme(swollen, "matrix");
    for (int i = 0; i < 5; ++i) scene.world().stepSimulation(kDt / 2, 5, kDt);
    const double time_beside_step = is_interpolated ? -0.5 : 0.5;
    EXPECT_NEAR(rigid_state.m_graphicsWorldTrans.getOrigin().x(), 2 + time_beside_step, 1e-6);
    EXPECT_EQ(swollen_state.m_graphicsWorldTrans.getOrigin().x(),
              rigid_state.m_graphicsWorldTrans.getOrigin().x());
    const RotationState state = scene.rotation().rotation_of(swollen).state;
    const Matrix3 shown = to_double(swollen_state.m_graphicsWorldTrans.getBasis());
    EXPECT_NEAR(shown.determinant(), state.R_WB.determinant(), by_precision(1e-6, 1e-14));
    // `matrix` turns by the angle whose tangent is omega dt; Bullet interpolates with omega
    const double angle = 2 * std::atan(0.25) + time_beside_step * std::atan(0.25);
    const double shown_angle = std::atan2(shown(1, 0), shown(0, 0));
    EXPECT_NEAR(shown_angle, angle, 0.01);
  }
}

// A body that is dropped while it swells comes to rest on the floor as if it had kept its size.
TYPED_TEST(Swelling, LeavesContactsAlive) {
  this->scene_.world().setGravity(btVector3(0, 0, -10));
  this->scene_.add_floor();
  const btVector3 half_extents = vector(0.5, 0.5, 0.5);
  const btTransform above(btQuaternion(btVector3(1, 2, 3).normalized(), btScalar(0.7)), btVector3(0, 0, 4));
  btRigidBody& swollen = this->scene_.add_box(half_extents, 1, above);
  swollen.setAngularVelocity(vector(4, 5, 6));
  this->scene_.rotation().set_scheme(swollen, "matrix");
  btRigidBody& below =
      this->scene_.add_box(half_extents, 1, btTransform(btQuaternion::getIdentity(), vector(0.6, 0, 0.5)));
  double lowest = 10;
  for (int i = 0; i < 256; ++i) {
    this->scene_.step(kDt);
    lowest = std::min<double>(lowest, swollen.getWorldTransform().getOrigin().z());
    EXPECT_TRUE(basis_of(below).allFinite());
  }
  EXPECT_EQ(this->scene_.rotation().incidents(), 0u);
  EXPECT_GT(this->scene_.rotation().rotation_of(swollen).state.R_WB.determinant(), 2.5);  // measured 2.94
  // The floor is at 0, half an edge below the centre; measured 0.481 and 0.5000
  EXPECT_GT(lowest, 0.4);
  EXPECT_NEAR(swollen.getWorldTransform().getOrigin().z(), 0.5, 0.01);
  EXPECT_LT(omega_of(swollen).norm(), 0.01);  // measured 2.4e-4 rad/s
  EXPECT_NEAR(below.getWorldTransform().getOrigin().z(), 0.5, 0.01);
}

TYPED_TEST(Swelling, WithoutBoundIsStoppedAndReportedOnce) {
  std::vector<Incident> reported;
  btMatrix3x3 stopped_at = btMatrix3x3::getIdentity();
  this->scene_.rotation().set_incident_handler([&](const Incident& incident) {
    reported.push_back(incident);
    stopped_at = incident.body->getWorldTransform().getBasis();
  });
  btRigidBody& body = this->add_swelling(64);  // its size grows by sqrt(2) per step
  btRigidBody& other = this->scene_.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  other.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, 0, 1e5)));
  this->scene_.step(kDt, 40);
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_EQ(reported[0].kind, IncidentKind::scheme_diverged);
  EXPECT_EQ(reported[0].body, &body);
  EXPECT_EQ(reported[0].body_steps, 26u);  // sqrt(2)^26 = 8192 is the last one below 10,000
  const BodyRotation rotation = this->scene_.rotation().rotation_of(body);
  EXPECT_TRUE(rotation.diverged);
  EXPECT_TRUE(same(stopped_at, to_bullet(rotation.state.q_WB.toRotationMatrix())));
  EXPECT_TRUE(rotation.state.all_finite());
  EXPECT_LE(rotation.state.R_WB.colwise().norm().maxCoeff(), kMaximumSwelling);
  EXPECT_TRUE(same(body.getAngularVelocity(), btVector3(0, 0, 0)));
  EXPECT_TRUE(body.isActive());
  EXPECT_FALSE(this->scene_.rotation().rotation_of(other).diverged);
  EXPECT_EQ(this->scene_.rotation().rotation_of(other).steps, 40u);
}

}  // namespace
}  // namespace polhode::testing
