// With negative steps time runs backwards: a free body returns to its start.
#include <gtest/gtest.h>

#include "support/both_ways.h"
#include "support/motion.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60);

template <class Way>
class NegativeSteps : public ::testing::Test {
 protected:
  // Bullet allows negative steps of variable length, but not of fixed length.
  void step(btScalar dt, int count) {
    for (int i = 0; i < count; ++i) scene_.world().stepSimulation(dt, 0);
  }

  Way scene_;
};
TYPED_TEST_SUITE(NegativeSteps, BothWays, WayName);

TYPED_TEST(NegativeSteps, TakeAFreeBodyBack) {
  for (const btVector3& omega_W : {btVector3(3, 2, 4), btVector3(100, 30, -60)}) {
    btRigidBody& body = this->scene_.add_free(btVector3(1, 2, 3), omega_W);
    const RotationState start = this->scene_.rotation().rotation_of(body).state;
    this->step(kDt, 600);
    EXPECT_GT(angle_between(basis_of(body), start.R_WB), 0.1);
    this->step(-kDt, 600);
    const RotationState end = this->scene_.rotation().rotation_of(body).state;
    // measured, at 5 and at 120 rad/s, 1.7e-14 and 2.6e-13 in single, 2.9e-14 and 1.0e-12 in double precision
    EXPECT_LT(distance(end.R_WB, start.R_WB), omega_W.length() < 10 ? 1e-13 : 4e-12);
    // measured 4.7e-15 and 1.2e-13 in single, 1.2e-14 and 1.8e-13 in double precision
    EXPECT_LT((end.omega_W - start.omega_W).norm() / start.omega_W.norm(),
              omega_W.length() < 10 ? 5e-14 : 6e-13);
    EXPECT_EQ(end.L_W, start.L_W);
  }
}

TYPED_TEST(NegativeSteps, LeaveEveryBodyFiniteInContactsAndJoints) {
  auto& scene = this->scene_;
  scene.world().setGravity(btVector3(0, 0, -10));
  scene.add_floor();
  scene.add_box(vector(0.3, 0.4, 0.5), 1, btTransform(btQuaternion::getIdentity(), vector(0, 0, 0.5)));
  btRigidBody& hinged = scene.add_free(btVector3(1, 2, 3), btVector3(1, 0, 3));
  scene.template join<btHingeConstraint>(hinged, btVector3(0, 0, 0), btVector3(0, 0, 1));
  this->step(kDt, 30);
  this->step(-kDt, 30);
  for (const auto& body : scene.bodies()) {
    EXPECT_TRUE(basis_of(*body).allFinite());
    EXPECT_TRUE(omega_of(*body).allFinite());
  }
  EXPECT_EQ(scene.rotation().incidents(), 0u);
}

// A damping of 1 multiplies the velocity by (1 - 1)^-dt, which is not finite. The velocity is kept instead.
TYPED_TEST(NegativeSteps, LeaveAFullyDampedBodyFinite) {
  btRigidBody& body = this->scene_.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  this->step(kDt, 1);
  const btVector3 omega_W = body.getAngularVelocity();
  body.setDamping(1, 1);
  this->step(-kDt, 1);
  // measured 0.24 rad/s, the gyroscopic change of a step
  EXPECT_LT((body.getAngularVelocity() - omega_W).length(), btScalar(0.5));
  EXPECT_TRUE(this->scene_.rotation().rotation_of(body).state.all_finite());
  EXPECT_EQ(this->scene_.rotation().incidents(), 1u);
}

// Steps of zero length change nothing.
TYPED_TEST(NegativeSteps, OfZeroLengthChangeNothing) {
  btRigidBody& body = this->scene_.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  this->step(kDt, 10);
  const btTransform pose = body.getWorldTransform();
  const btVector3 omega_W = body.getAngularVelocity();
  this->step(0, 10);
  EXPECT_TRUE(same(body.getWorldTransform().getBasis(), pose.getBasis()));
  EXPECT_TRUE(same(body.getAngularVelocity(), omega_W));
}

}  // namespace
}  // namespace polhode::testing
