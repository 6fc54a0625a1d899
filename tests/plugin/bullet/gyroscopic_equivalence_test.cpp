// The handout's gyroscopic terms are Bullet's: the velocity change in a step of the scheme equals Bullet's,
// for 10,000 random bodies.
#include <gtest/gtest.h>

#include <limits>

#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"
#include "polhode/scheme_registry.h"
#include "support/precision.h"
#include "support/random_body.h"
#include "support/scene.h"

namespace polhode::testing {
namespace {

constexpr double kUlp = std::numeric_limits<btScalar>::epsilon();
constexpr btScalar kDt = btScalar(1.0 / 60.0);

struct RandomRigidBody {
  explicit RandomRigidBody(RandomBody& random) : body(1, nullptr, nullptr, to_bullet(random.inertia_B())) {
    body.setWorldTransform(btTransform(to_bullet(random.q_WB().toRotationMatrix())));
    body.setAngularVelocity(to_bullet(random.omega_W()));
    body.updateInertiaTensor();
  }

  // Returns state and inertia as stored by Bullet, in double.
  Vector3 inertia_B() const { return to_double(body.getInvInertiaDiagLocal()).cwiseInverse(); }

  RotationState state() const {
    RotationState state;
    set_orientation(state, to_quaternion(body.getWorldTransform().getBasis()));
    set_omega(state, inertia_B(), to_double(body.getAngularVelocity()));
    return state;
  }

  Vector3 change_by(const char* scheme) const {
    RotationState end = state();
    find_scheme(scheme)->step({inertia_B(), Vector3::Zero(), kDt}, end);
    return end.omega_W - state().omega_W;
  }

  btRigidBody body;
};

// Counts differences in ulp of the effect of rounding the inputs: an ulp of the velocity, and an ulp of the
// terms of omega x I omega (up to |omega|^2 times the largest moment) and of J through the solution for the
// change.

TEST(GyroscopicEquivalence, ImplicitIsBulletsImplicitBodyTerm) {
  RandomBody random(3);
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const RandomRigidBody rigid(random);
    const Vector3 bullets = to_double(rigid.body.computeGyroscopicImpulseImplicit_Body(kDt));
    const double speed = rigid.state().omega_W.norm();
    const Matrix3 R_BW = rigid.state().R_WB.transpose();
    Matrix3 jacobian = kDt * (skew(R_BW * rigid.state().omega_W) * rigid.inertia_B().asDiagonal() -
                              skew(R_BW * rigid.state().L_W));
    jacobian.diagonal() += rigid.inertia_B();
    const double torque_impulse = kDt * speed * speed * rigid.inertia_B().maxCoeff();
    const double ulp =
        kUlp * (speed + jacobian.inverse().norm() * (torque_impulse + jacobian.norm() * bullets.norm()));
    worst = std::max(worst, (rigid.change_by("implicit_gyroscopic") - bullets).norm() / ulp);
  }
  // measured 2.8 in single precision, where only Bullet rounds, 9.4 in double, where both sides round
  EXPECT_LE(worst, by_precision(6.0, 20.0));
}

TEST(GyroscopicEquivalence, SemiImplicitIsBulletsUncappedExplicitTerm) {
  RandomBody random(4);
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const RandomRigidBody rigid(random);
    const btVector3 torque = rigid.body.computeGyroscopicForceExplicit(BT_LARGE_FLOAT);
    const Vector3 bullets = -to_double(torque * rigid.body.getInvInertiaTensorWorld() * kDt);
    const double speed = rigid.state().omega_W.norm();
    const double torque_impulse = kDt * speed * speed * rigid.inertia_B().maxCoeff();
    const double ulp = kUlp * (speed + torque_impulse / rigid.inertia_B().minCoeff());
    worst = std::max(worst, (rigid.change_by("semi_implicit_gyroscopic") - bullets).norm() / ulp);
  }
  // measured 1.1 in single, 7.5 in double precision
  EXPECT_LE(worst, by_precision(2.5, 16.0));
}

}  // namespace
}  // namespace polhode::testing
