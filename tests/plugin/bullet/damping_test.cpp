// With damping by Bullet, the body turns by the velocity that it reports, whatever else acts.
#include <gtest/gtest.h>

#include <cmath>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/precision.h"

namespace polhode::testing {
namespace {

constexpr double kDt = 1.0 / 60;

template <class Way>
class Damping : public ::testing::Test {
 protected:
  Way scene_;
};
TYPED_TEST_SUITE(Damping, BothWays, WayName);

// A damping of 1 stops the body in each step: its velocity is what the torque adds in one step.
TYPED_TEST(Damping, WithATorqueTurnsTheBodyByTheVelocityThatItShows) {
  for (const double damping : {1.0, 0.999, 0.5}) {
    btRigidBody& body = this->scene_.add_free(btVector3(2, 2, 2), btVector3(0, 0, 0));
    body.setDamping(0, btScalar(damping));
    double turned = 0, shown = 0;
    for (int i = 0; i < 120; ++i) {
      const Matrix3 before = basis_of(body);
      body.applyTorque(btVector3(0, 10, 0));
      this->scene_.step(btScalar(kDt));
      turned += turn_between(before, basis_of(body)).y();
      shown += omega_of(body).y() * kDt;
    }
    // measured 5.8e-8 in single, 1.6e-15 in double precision
    EXPECT_NEAR(turned / shown, 1, by_precision(2e-7, 6e-15)) << damping;
    EXPECT_GT(turned, 0.1) << damping;
  }
}

TYPED_TEST(Damping, WithATorqueHasTheVelocityOfPlainBullet) {
  for (const double damping : {1.0, 0.999, 0.5}) {
    Scene<> plain;
    btRigidBody& bullets = plain.add_free(btVector3(2, 2, 2), btVector3(0, 0, 0));
    btRigidBody& body = this->scene_.add_free(btVector3(2, 2, 2), btVector3(0, 0, 0));
    for (btRigidBody* either : {&bullets, &body}) either->setDamping(0, btScalar(damping));
    for (int i = 0; i < 120; ++i) {
      for (btRigidBody* either : {&bullets, &body}) either->applyTorque(btVector3(0, 10, 0));
      plain.step(btScalar(kDt));
      this->scene_.step(btScalar(kDt));
    }
    // measured 1.8e-6 in single, 1.3e-15 in double precision, relative
    EXPECT_NEAR(omega_of(body).y() / omega_of(bullets).y(), 1, by_precision(6e-6, 5e-15)) << damping;
  }
}

// Damping scales the momentum: a tumble keeps its direction, and its energy falls by the square of the
// factor.
TYPED_TEST(Damping, AloneScalesTheMomentum) {
  btRigidBody& body = this->scene_.add_free(btVector3(1, 2, 3), btVector3(3, 2, 4));
  body.setDamping(0, btScalar(0.3));
  const Vector3 start_W = shown_angular_momentum_W(body);
  this->scene_.step(btScalar(kDt), 300);
  const Vector3 expected_W = start_W * std::pow(0.7, 5);
  // measured 5.6e-6 in single (Bullet's own factor is rounded), 1.4e-14 in double precision
  EXPECT_LT((shown_angular_momentum_W(body) - expected_W).norm() / expected_W.norm(),
            by_precision(2e-5, 5e-14));
}

// The momentum that a constrained body has in addition to its velocity is damped as well.
TYPED_TEST(Damping, OnAHingeLeavesTheAxisAlone) {
  const HingedBody rod = add_hinged_rod(this->scene_, 15);
  rod.body.setDamping(0, btScalar(0.3));
  const double start = energy_of(rod.body);
  for (int i = 0; i < 300; ++i) {
    this->scene_.step(btScalar(kDt));
    // measured 4.9e-8 in single, 7.7e-16 in double precision
    ASSERT_LT(rod.axis_off(), by_precision(2e-7, 3e-15)) << i;
  }
  // measured 1.0002; plain Bullet 0.21
  EXPECT_NEAR(energy_of(rod.body) / start / std::pow(0.7, 10), 1, 1e-3);
}

}  // namespace
}  // namespace polhode::testing
